using Nowpose.Cli.Calibrate.Head;
using Nowpose.Cli.Calibrate.Vlc;
using Nowpose.Vision;

namespace Nowpose.Cli.Calibrate.Sine;

/// <summary>Measures a jog in a video. Tracks one patch of the robot and one of the hologram from frame to frame.</summary>
static class FilmedJog
{
    /// <summary>Minimum match score. Below it, the patch is lost.</summary>
    const double MinScore = 0.5;

    /// <summary>Tracks both patches to the end of the video, or until the user cancels.</summary>
    /// <param name="readoutMs">Time between the exposures of the first and the last row, ms.</param>
    /// <exception cref="OperationCanceledException">The user cancelled before the first picture.</exception>
    /// <exception cref="InputException">A box is missing or outside the picture, a patch is lost, or the video cannot be read.</exception>
    public static SineTracks Track(string path, PictureBox? robotBox, PictureBox? hologramBox, double readoutMs, CancellationToken cancel)
    {
        PictureBox robot = Required(robotBox, "--robot-box"), hologram = Required(hologramBox, "--hologram-box");
        var times = VideoFrames.TimesOf(path);
        var places = new List<IReadOnlyList<TrackedPlace>>(times.Length);
        var rows = 0;
        using var tracker = new MotionTracker([robot, hologram]);
        ConsoleProgress.Run(SinePageTexts.Tracking, "pictures", times.Length, report =>
        {
            foreach (var (width, height, bytes) in VideoFrames.Read(path))
            {
                if (places.Count == times.Length || cancel.IsCancellationRequested) break;
                rows = height;
                if (places.Count == 0) RequireWithin(robot, width, height, "--robot-box");
                if (places.Count == 0) RequireWithin(hologram, width, height, "--hologram-box");
                places.Add(tracker.Follow(width, height, bytes));
                RequireMatches(places[^1], path, places.Count);
                report(places.Count);
            }
        });
        if (places.Count == 0) cancel.ThrowIfCancellationRequested();
        var axis = MotionAxis.Of([.. places.Select(each => (each[0].X, each[0].Y))]);
        double[] Along(int patch) => [.. places.Select(each => axis.LengthOf((each[patch].X, each[patch].Y), default))];
        var lower = places.Average(each => each[1].Y - each[0].Y);
        return SineTracks.Of(times[..places.Count], Along(0), Along(1), path) with { LaterMs = readoutMs * lower / rows };
    }

    static PictureBox Required(PictureBox? box, string option) => box ?? throw new InputException(SineMessages.NoBox(option));

    static void RequireWithin(PictureBox box, int width, int height, string option)
    {
        if (box.X + box.Width <= width && box.Y + box.Height <= height) return;
        throw new InputException(SineMessages.BoxOutside(option, box.X, box.Y, box.Width, box.Height, width, height));
    }

    static void RequireMatches(IReadOnlyList<TrackedPlace> places, string path, int frame)
    {
        for (var i = 0; i < places.Count; i++)
            if (!(places[i].Score >= MinScore))
                throw new InputException(SineMessages.PatchLost(path, frame, i == 0, places[i].Score, MinScore));
    }
}
