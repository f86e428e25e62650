// An error in line 4.
float Wrong()
{
    return undeclared;
}
