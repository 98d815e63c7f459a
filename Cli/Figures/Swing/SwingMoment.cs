using Nowpose.Cli.Studies;

namespace Nowpose.Cli.Figures.Swing;

/// <summary>An instant of the first move that is named in Figs 16 and 17.</summary>
/// <param name="Index">Index of the frame in <see cref="SwingFrames.Shown"/>.</param>
sealed record SwingMoment(string Name, string Description, int Index)
{
    /// <summary>Gets the three instants: A when full speed is reached, B halfway, C when the speed has dropped to half.</summary>
    public static IReadOnlyList<SwingMoment> Of(YoubotSwing swing, IReadOnlyList<StudyFrame> frames)
    {
        var full = swing.FullSpeed;
        var move = Enumerable.Range(0, frames.Count).Where(i => frames[i].Time >= 0 && frames[i].Time < swing.MoveSeconds).ToArray();
        int First(Func<double, bool> when) => move.First(i => when(frames[i].Time));
        return
        [
            new("A", Figure17Texts.FullSpeed, First(t => swing.ToolSpeedAt(t) >= 0.999 * full)),
            new("B", "halfway", First(t => t >= swing.MoveSeconds / 2)),
            new("C", Figure17Texts.HalfSpeed, move.Last(i => swing.ToolSpeedAt(frames[i].Time) >= full / 2)),
        ];
    }
}
