using System.Globalization;
using Nowpose.Cli.Calibrate.Range;
using Nowpose.Gateway;
using Nowpose.Latency;
using Nowpose.Web;

namespace Nowpose.Cli.Calibrate;

/// <summary>The output folder of a calibration. Files of an earlier calibration are kept until new files are written.</summary>
sealed class CalibrationOutput
{
    readonly string _folder;

    CalibrationOutput(string folder) => _folder = folder;

    /// <summary>Path of the profile for the headset. <see cref="LatencyProfileFile"/> reads this file.</summary>
    public string ProfilePath => Path.Combine(_folder, "profile.json");

    public string PagePath => Path.Combine(_folder, "calibration.html");

    /// <summary>Path for a new profile without a render time limit. Used if the existing profile has a limit.</summary>
    public string UnlimitedProfilePath => Path.Combine(_folder, "profile-without-limit.json");

    /// <summary>Path for the profile of an interrupted measurement. Used if there is an earlier profile.</summary>
    public string InterruptedProfilePath => Path.Combine(_folder, "profile-interrupted.json");

    /// <summary>Path of the table that <c>calibrate range</c> reads.</summary>
    public string PairsPath => Path.Combine(_folder, "pairs.csv");

    /// <summary>Path for the table of an interrupted measurement. Used if there is an earlier table.</summary>
    public string InterruptedPairsPath => Path.Combine(_folder, "pairs-interrupted.csv");

    /// <summary>Creates the folder and checks that its files can be written, so that a long measurement does not fail at its end.</summary>
    /// <param name="hasPairs">Whether <see cref="WritePairs"/> will be called. Without it, the table may be an input of the command.</param>
    /// <exception cref="InputException">The folder or an existing file in it is not writable.</exception>
    public static CalibrationOutput At(string folder, bool hasPairs = false) => OptionPath.InFolder("--out", folder, full =>
    {
        var output = new CalibrationOutput(full);
        // Opens the files of an earlier calibration without changing them.
        string[] written = [output.ProfilePath, output.UnlimitedProfilePath, output.InterruptedProfilePath, output.PagePath];
        if (hasPairs) written = [.. written, output.PairsPath, output.InterruptedPairsPath];
        foreach (var path in written.Select(OutputFile.TargetOf).Where(Path.Exists))
            File.Open(path, FileMode.Open, FileAccess.Write).Dispose();
        return output;
    });

    /// <summary>
    /// Writes the profile and then the page. An existing profile that has a limit is not replaced by one without a limit, and none is replaced by the
    /// profile of an interrupted measurement. The same applies to the table.
    /// </summary>
    /// <param name="profile">The profile; null if there is none.</param>
    /// <returns>Path of the written profile; null if none was written.</returns>
    /// <exception cref="InputException">A file cannot be written.</exception>
    public string Write(LatencyProfile profile, CalibrationPageData page, bool isInterrupted = false)
    {
        var path = profile == null ? null : isInterrupted && Path.Exists(ProfilePath) ? InterruptedProfilePath
            : profile.Range == null && EarlierLimit() is TimeSpan limit ? PathBeside(limit) : ProfilePath;
        if (profile != null) OptionPath.Write("--out", path, () => LatencyProfileFile.Save(path, profile));
        OptionPath.Write("--out", PagePath, () => OutputFile.Write(PagePath, Pages.Calibration.Render(CalibrationJson.Of(page))));
        return path;
    }

    /// <exception cref="InputException">The file cannot be written.</exception>
    public void WritePairs(IEnumerable<MeasuredPicture> pictures, PairOrigin origin, bool isInterrupted = false)
    {
        var path = isInterrupted && Path.Exists(PairsPath) ? InterruptedPairsPath : PairsPath;
        OptionPath.Write("--out", path, () => OutputFile.Write(path, file => WritePairs(file, pictures, origin)));
    }

    static void WritePairs(TextWriter file, IEnumerable<MeasuredPicture> pictures, PairOrigin origin)
    {
        file.Write($"file,vertices,render_ms,visu_ms,{string.Join(',', PairOrigin.Columns)}\n");
        var ends = string.Join(',', origin.Values.Select(CsvField.Quoted));
        foreach (var picture in pictures.Where(each => each.RenderMs.HasValue))
            file.Write(string.Create(
                CultureInfo.InvariantCulture,
                $"{CsvField.Quoted(picture.File)},{picture.Vertices},{picture.RenderMs:0.####},{picture.VisuMs:0.####},{ends}\n"));
    }

    // Gets the path for a profile without a limit, and prints a message that the existing profile is kept.
    string PathBeside(TimeSpan limit)
    {
        Console.Error.WriteLine(ConsoleMessages.ProfileKept(ProfilePath, limit.TotalMilliseconds));
        return UnlimitedProfilePath;
    }

    // Gets the limit of the existing profile; null if the profile has no limit, is missing or is not readable.
    TimeSpan? EarlierLimit()
    {
        try
        {
            return File.Exists(ProfilePath) ? LatencyProfileFile.Load(ProfilePath).Range?.Limit : null;
        }
        catch (InputException)
        {
            return null;
        }
    }
}
