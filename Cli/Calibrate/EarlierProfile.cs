using System.CommandLine;
using Nowpose.Gateway.Options;
using Nowpose.Latency;
using Nowpose.Latency.Conditions;
using Nowpose.Latency.Profile;

namespace Nowpose.Cli.Calibrate;

/// <summary><c>--profile</c>: an earlier profile whose render time limit is kept by methods that measure only L_visu.</summary>
/// <remarks>If no profile was given, the object contains only the conditions of the measurement, and warnings about them.</remarks>
sealed class EarlierProfile
{
    readonly IReadOnlyList<string> _warnings;

    EarlierProfile(LatencyProfile profile, DisplayConditions conditions, IReadOnlyList<string> warnings)
    {
        Profile = profile;
        Conditions = profile == null ? conditions : conditions.Or(profile.Conditions);
        _warnings = warnings;
    }

    /// <summary>The earlier profile; null if none was given.</summary>
    public LatencyProfile Profile { get; }

    /// <summary>Conditions of the measurement. Options take precedence over the sweep's log, and the log over the earlier profile.</summary>
    public DisplayConditions Conditions { get; }

    public static Option<string> Option() => TextOption.Create("--profile", "An earlier profile of the same device, whose render time limit is kept");

    /// <summary>Reads the profile. Call this method before the measurement, so that an invalid profile is reported early.</summary>
    /// <param name="path">Path of the profile; null if none was given.</param>
    /// <param name="given">Conditions given as options.</param>
    /// <param name="sweep">Conditions from the sweep's log; null without a log.</param>
    /// <exception cref="InputException">The file is not a readable profile, or belongs to another device or display rate.</exception>
    public static EarlierProfile Read(string path, DisplayConditions given, DisplayConditions sweep = null)
    {
        var warnings = new List<string>();
        if (sweep != null)
            warnings.AddRange(sweep.MismatchesWith(given).Select(each => CalibrationMessages.OtherSweep(each.Label, each.Calibrated, each.Actual)));
        var conditions = sweep == null ? given : given.Or(sweep);
        var profile = path == null ? null : LatencyProfileFile.Load(path);
        if (profile?.RefusalFor(conditions) is string refusal) throw new InputException($"--profile: {path}: {refusal}");
        if (profile != null)
            warnings.AddRange(profile.MismatchesWith(conditions).Select(each =>
                CalibrationMessages.OtherProfile(path, each.Label, each.Calibrated, each.Actual)));
        return new EarlierProfile(profile, conditions, warnings);
    }

    /// <summary>Returns the page with the warnings about different conditions before its other warnings.</summary>
    public CalibrationPageData WithWarnings(CalibrationPageData page) => page with { Warnings = [.. _warnings, .. page.Warnings] };

    /// <summary>Returns the earlier profile with the given latency for head motion; null without an earlier profile.</summary>
    public LatencyProfile With(HeadMotionLatency head) => Profile == null ? null : new(
        Profile.Visualisation.Length.TotalMilliseconds, Profile.Spread.TotalMilliseconds, Conditions, Profile.MeasuredUtc, Profile.Method,
        Profile.Measurements, Profile.Range?.Limit.TotalMilliseconds, Profile.RenderTimeSource, Profile.ValidToRenderTime?.TotalMilliseconds, head);

    /// <summary>Returns a profile with the given L_visu. Keeps the latency for head motion, which is measured separately.</summary>
    public LatencyProfile With(double visuMs, double spreadMs, CalibrationMethod method, int measurements) => new(
        visuMs, spreadMs, Conditions, DateTime.UtcNow, method, measurements, Profile?.Range?.Limit.TotalMilliseconds,
        Profile?.RenderTimeSource ?? RenderTimeSourceKind.None, Profile?.ValidToRenderTime?.TotalMilliseconds, Profile?.HeadMotion);
}
