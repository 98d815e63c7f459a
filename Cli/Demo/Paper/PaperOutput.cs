using System.Globalization;
using Nowpose.Cli.Calibrate;
using Nowpose.Cli.Figures.Clocks;
using Nowpose.Cli.Figures.Model;
using Nowpose.Gateway;

namespace Nowpose.Cli.Demo.Paper;

/// <summary>Writes the files of <c>--paper</c>: the figures' data, the calibration, and the frames and exchanges of all repeats.</summary>
static class PaperOutput
{
    const string Frames = "frames.csv", Exchanges = "exchanges.csv", Profile = "profile.json", CalibrationPage = "calibration.html";

    /// <summary>Removes the files of an earlier run, which could be mistaken for new ones.</summary>
    public static void RemoveEarlier(string folder)
    {
        // Keeps the profile if the frames file is missing, because the profile can then be the user's own.
        string[] ofPaper = File.Exists(Path.Combine(folder, Frames)) ? [Profile, CalibrationPage] : [];
        foreach (var name in ofPaper.Concat(["figure-8.csv", "figure-16.csv", "figure-17.csv", "figure-18.csv", Exchanges, Frames]))
            File.Delete(Path.Combine(folder, name));
    }

    public static void Write(string folder, IReadOnlyList<PaperRun> repeats, PaperCalibration calibration, IReadOnlyList<Figure> figures)
    {
        OutputFile.Write(Path.Combine(folder, Frames), (TextWriter file) => WriteFrames(file, repeats));
        OutputFile.Write(Path.Combine(folder, Exchanges), (TextWriter file) => WriteExchanges(file, repeats));
        foreach (var figure in figures) OutputFile.Write(Path.Combine(folder, figure.FileName), figure.Table.WriteCsv);
        CalibrationOutput.At(folder).Write(calibration.Profile, calibration.Page);
    }

    /// <summary>Writes each frame with a display time: true, displayed and uncompensated position of the tool at the display time.</summary>
    public static void WriteFrames(TextWriter writer, IEnumerable<PaperRun> repeats)
    {
        writer.Write("repeat,elapsed_s,true_light_s,assumed_light_s,offset_error_us,skew_ppm,swing,swing_s,"
            + "true_x_m,true_y_m,true_z_m,shown_x_m,shown_y_m,shown_z_m,held_x_m,held_y_m,held_z_m\n");
        foreach (var repeat in repeats)
        {
            foreach (var row in repeat.Run.Frames.Rows.Where(row => row.AssumedLight.HasValue))
            {
                var (swing, time) = repeat.TimeOf(row);
                writer.Write(string.Create(
                    CultureInfo.InvariantCulture,
                    $"{repeat.Repeat},{row.Elapsed.TotalSeconds:0.######},{Seconds(row.TrueLight)},{Seconds(row.AssumedLight.Value)},")
                    + string.Create(CultureInfo.InvariantCulture, $"{row.OffsetErrorUs:0.###},{1e6 * row.Clock.Skew:0.###},{swing},{time:0.######},")
                    + $"{Text(repeat.TruthOf(row))},{Text(row.Tool)},{Text(row.HeldTool)}\n");
            }
        }
    }

    /// <summary>
    /// Writes each exchange with the clock estimate after it, and its timestamps as <c>sync</c> reads them. Offsets are relative to the offset of the
    /// first exchange.
    /// </summary>
    public static void WriteExchanges(TextWriter writer, IEnumerable<PaperRun> repeats)
    {
        writer.Write("repeat,time_s,offset_ms,true_offset_ms,fitted_offset_ms,skew_ppm,theta2_ms,fit_error_ms,round_trip_ms,"
            + "t1_ns,t2_ns,t3_ns,t4_ns\n");
        foreach (var repeat in repeats)
            foreach (var step in repeat.Steps)
                writer.Write(string.Create(CultureInfo.InvariantCulture, $"{repeat.Repeat},")
                    + Text(step, (repeat.Run.Truth.OffsetAt(step.At) - repeat.Run.Exchanges[0].Offset).TotalMilliseconds) + "\n");
    }

    static string Text(SyncStep s, double trueOffsetMs) => string.Create(
        CultureInfo.InvariantCulture,
        $"{s.Seconds:0.######},{s.OffsetMs:0.####},{trueOffsetMs:0.####},{s.FitMs:0.####},{s.SkewPpm:0.###},{s.InterceptMs:0.####},")
        + string.Create(CultureInfo.InvariantCulture, $"{s.FitErrorMs:0.####},{s.RoundTripMs:0.####},")
        + string.Create(CultureInfo.InvariantCulture, $"{Nanoseconds(s.Exchange.T1.SinceEpoch)},{Nanoseconds(s.Exchange.T2.SinceEpoch)},")
        + string.Create(CultureInfo.InvariantCulture, $"{Nanoseconds(s.Exchange.T3.SinceEpoch)},{Nanoseconds(s.Exchange.T4.SinceEpoch)}");

    static long Nanoseconds(TimeSpan sinceEpoch) => sinceEpoch.Ticks * TimeSpan.NanosecondsPerTick;

    static string Text(ToolPosition p) => string.Create(CultureInfo.InvariantCulture, $"{p.X:0.#######},{p.Y:0.#######},{p.Z:0.#######}");

    // Computes in decimal, because a double has too few digits for ticks since 1970.
    static string Seconds(ControlTime t) =>
        ((decimal)t.SinceEpoch.Ticks / TimeSpan.TicksPerSecond).ToString("0.0000000", CultureInfo.InvariantCulture);
}
