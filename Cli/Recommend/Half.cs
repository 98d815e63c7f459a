namespace Nowpose.Cli.Recommend;

/// <summary>Half of a recording. A candidate is evaluated on both halves separately and must be better on both.</summary>
/// <remarks>Each half contains half of the motion; see <see cref="MotionHalves"/>.</remarks>
enum Half
{
    First,
    Second,
}
