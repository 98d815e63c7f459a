using System.CommandLine;
using Nowpose.Gateway.Options;
using Nowpose.Latency;
using Nowpose.Latency.Conditions;

namespace Nowpose.Cli.Calibrate;

/// <summary>The options that all calibration methods share: output, format, and the conditions of the measurement.</summary>
sealed class CalibrationOptions
{
    readonly Option<string> _folder = TextOption.Create(
        "--out", "Folder for profile.json, calibration.html and, for vlc with --sweep, pairs.csv", standard: "nowpose-calibration");

    readonly Option<bool> _json = SwitchOption.Create("--json", "Print JSON instead of a table");
    readonly DeviceOptions _device = new();

    public void AddTo(Command verb)
    {
        verb.Options.Add(_folder);
        verb.Options.Add(_json);
        _device.AddTo(verb);
    }

    /// <inheritdoc cref="DeviceOptions.Conditions"/>
    public DisplayConditions Conditions(ParseResult parsed) => _device.Conditions(parsed);

    /// <inheritdoc cref="CalibrationOutput.At"/>
    public CalibrationOutput Output(ParseResult parsed, bool hasPairs = false) => CalibrationOutput.At(parsed.GetValue(_folder), hasPairs);

    /// <summary>Writes the profile and the page, and prints the result.</summary>
    /// <param name="profile">The profile; null if there is none.</param>
    /// <param name="json">Creates the JSON that is printed instead of the table on request.</param>
    /// <param name="isInterrupted">Whether the user interrupted the measurement, so that pictures are missing.</param>
    public void Finish(
        ParseResult parsed, CalibrationOutput output, LatencyProfile profile, CalibrationPageData page, Func<string> json, bool isInterrupted = false)
    {
        if (isInterrupted) page = page.WithWarning(CalibrationMessages.Interrupted);
        CalibrationTable.Print(page, output.Write(profile, page, isInterrupted), output.PagePath, parsed.GetValue(_json) ? json() : null);
    }
}
