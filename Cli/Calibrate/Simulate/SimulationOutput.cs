using Nowpose.Gateway;
using Nowpose.Latency;
using Nowpose.Latency.Sweep;
using Nowpose.Vision;

namespace Nowpose.Cli.Calibrate.Simulate;

/// <summary>Writes a folder with pictures, the sweep's log and the true values, to test the complete evaluation without hardware.</summary>
static class SimulationOutput
{
    const string TruthFile = "truth.csv", LogFile = "sweep.csv";
    const string TruthHeader = "file,led_ms,headset_ms,visu_ms,spoiled";

    /// <returns>Number of pictures written.</returns>
    public static int Write(SimulationSettings settings, string folder, CancellationToken cancellation)
    {
        var sweep = new SimulatedSweep(settings);
        var camera = new SimulatedCamera(settings, sweep);
        var pictures = Path.Combine(Made(folder), "pictures");
        Made(pictures);
        // Without Node.js, this throws before the folder is changed.
        using var pool = new VisionPool();
        RemoveEarlier(folder, pictures);
        // Written before the log, because the log of a simulation that failed must not look like the log of a measurement.
        OutputFile.Write(Path.Combine(folder, TruthFile), TruthHeader + "\n");
        OutputFile.Write(Path.Combine(folder, LogFile), log =>
        {
            SweepLog.WriteHeader(log);
            foreach (var row in sweep.Rows) SweepLog.Write(log, row);
        });
        var defects = new string[settings.Pictures];
        string NameOf(int picture) => FormattableString.Invariant($"picture-{picture + 1:00000}.jpg");
        var made = new SortedSet<int>();
        ConsoleProgress.Run("taking pictures", "pictures", settings.Pictures, report => pool.Look(
            Enumerable.Range(0, settings.Pictures).Select(i => PictureRequest.Made(camera.Take(i, out defects[i]), Path.Combine(pictures, NameOf(i)))),
            (place, picture) =>
            {
                if (picture.Fault != null) throw new InputException($"--out: {folder}: {picture.Fault}");
                made.Add(place);
                report(made.Count);
            },
            cancellation));
        // After a cancellation, only the finished pictures are listed.
        OutputFile.Write(Path.Combine(folder, TruthFile), truth =>
        {
            truth.Write(TruthHeader + "\n");
            foreach (var i in made) truth.Write(TruthOf(sweep, i, NameOf(i), defects[i]) + "\n");
        });
        return made.Count;
    }

    static string TruthOf(SimulatedSweep sweep, int picture, string name, string defect)
    {
        var moment = sweep.Moments[picture];
        var start = sweep.StartOf(moment.Frame);
        var led = moment.Middle.SinceEpoch.TotalMilliseconds % TimestampCode.PeriodMs;
        return FormattableString.Invariant($"{name},{led:0.000},{TimestampCode.ValueOf(start)},{sweep.VisuMsOf(moment):0.000},{defect}");
    }

    // Removes the pictures of an earlier run. Without a truth file, pictures and log can come from a real measurement, so the folder is rejected.
    static void RemoveEarlier(string folder, string pictures)
    {
        var earlier = Directory.GetFiles(pictures, "picture-*.jpg");
        if (!File.Exists(Path.Combine(folder, TruthFile)))
        {
            if (earlier.Length > 0) throw new InputException(SimulationMessages.OtherPictures(folder, earlier.Length, TruthFile));
            if (File.Exists(Path.Combine(folder, LogFile))) throw new InputException(SimulationMessages.OtherLog(folder, LogFile, TruthFile));
        }
        foreach (var picture in earlier.Concat(Directory.GetFiles(pictures, "picture-*.jpg.new"))) File.Delete(picture);
    }

    static string Made(string folder) => OptionPath.InFolder("--out", folder, full => full);
}
