using Nowpose.Latency;
using Nowpose.Vision;

namespace Nowpose.Cli.Calibrate.Vlc;

/// <summary>Computes L_visu by Eq. (7) from the codes in a picture.</summary>
/// <param name="ReadoutMs">Readout time of a rolling shutter: delay between the exposures of the first and the last row, ms.</param>
/// <param name="ControlDelayMs">Latency of the device that shows the control code, ms: a few tenths for LEDs, several frames for a monitor.</param>
sealed record PictureReader(double ReadoutMs, double ControlDelayMs)
{
    /// <summary>Plausible range of L_visu, ms. A value outside it means a misread code or clocks that are not synchronised.</summary>
    const double MinVisuMs = -50, MaxVisuMs = 500;

    /// <summary>Maximum difference between the two methods of reading a control code, ms. The brightest code is not always the middle one.</summary>
    const double MaxDifferenceMs = 2;

    public PictureResult Read(string file, SeenPicture seen)
    {
        if (seen.Fault != null) return PictureResult.Not(file, $"unreadable: {seen.Fault}");
        seen = seen with { Codes = [.. seen.Codes.Where(code => !code.IsWeak || ReadingOf(code, seen).Fault == null)] };
        if (CodeFaults.Of(seen) is string fault) return PictureResult.Not(file, fault);
        var (control, headset) = (seen.CodesOf(CodeKind.Control)[0], seen.CodesOf(CodeKind.Headset)[0]);
        var shown = ReadingOf(headset, seen);
        if (shown.Fault != null) return PictureResult.Not(file, $"headset code {shown.Fault}");
        var lit = ReadingOf(control, seen);
        if (lit.Fault != null) return PictureResult.Not(file, $"control code {lit.Fault}");
        // Control time at which the rows of the headset's code were exposed.
        var later = ReadoutMs * (MiddleOf(headset) - MiddleOf(control)) / seen.Height;
        var led = Wrapped(lit.Ms + ControlDelayMs + later);
        var visu = Wrapped(led - shown.Ms + TimestampCode.PeriodMs / 2) - TimestampCode.PeriodMs / 2;
        return visu is >= MinVisuMs and <= MaxVisuMs
            ? new PictureResult(file, led, shown.Ms, visu, null) { Places = new CodePlaces(control.Center, headset.Center, later) }
            : PictureResult.Not(file, visu > MaxVisuMs
                ? PictureFaults.FarApart(MaxVisuMs)
                : PictureFaults.HeadsetAhead(-MinVisuMs));
    }

    Reading ReadingOf(FoundCode code, SeenPicture seen) => code.Kind == CodeKind.Headset
        ? HeadsetCode.Read(new CodeContrasts(code))
        : ReadControl(new CodeContrasts(code), DelaysOf(code, seen.Height));

    /// <summary>
    /// Reads the code of the control clock. LEDs show several consecutive codes; a monitor shows one code per frame and can skip any number.
    /// </summary>
    static Reading ReadControl(CodeContrasts contrasts, double[] delaysMs)
    {
        Reading run = ControlCode.Read(contrasts, delaysMs), frame = HeadsetCode.Read(contrasts, minStep: 1);
        if (run.Fault == null && frame.Fault == null && Math.Abs(Math.IEEERemainder(run.Ms - frame.Ms, TimestampCode.PeriodMs)) > MaxDifferenceMs)
            return Reading.Not(PictureFaults.AmbiguousTime);
        return run.Fault == null || frame.Fault != null ? run : frame;
    }

    double[] DelaysOf(FoundCode code, int height)
    {
        var middle = MiddleOf(code);
        var delays = new double[TimestampCode.PairCount];
        for (var pair = 0; pair < delays.Length; pair++)
        {
            var cell = TimestampCode.CellOf(pair);
            delays[pair] = ReadoutMs * (code.HeightOf(cell % TimestampCode.Side + 1, cell / TimestampCode.Side + 0.5) - middle) / height;
        }
        return delays;
    }

    static double MiddleOf(FoundCode code) => code.HeightOf(TimestampCode.Side / 2.0, TimestampCode.Side / 2.0);

    static double Wrapped(double ms) => ms - TimestampCode.PeriodMs * Math.Floor(ms / TimestampCode.PeriodMs);
}
