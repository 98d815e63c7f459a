namespace Nowpose.Cli.Recommend;

/// <summary>Part of a recording that candidates are tried on by themselves: what wins in one must win in the other.</summary>
/// <remarks>Either has half of the motion, see <see cref="Halving"/>.</remarks>
enum Half
{
    First,
    Second,
}
