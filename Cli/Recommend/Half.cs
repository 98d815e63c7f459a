namespace Nowpose.Cli.Recommend;

/// <summary>Part of a recording on which candidates are tried separately. A candidate must win in both halves.</summary>
/// <remarks>Each half has half of the motion; see <see cref="Halving"/>.</remarks>
enum Half
{
    First,
    Second,
}
