using System.Globalization;
using Nowpose.Cli.Messages;
using Nowpose.Latency;
using Nowpose.Web;

namespace Nowpose.Cli.Calibrate;

/// <summary>The folder that a calibration writes to. The files of an earlier calibration stay until there is a better result.</summary>
sealed class CalibrationOutput
{
    readonly string _folder;

    CalibrationOutput(string folder) => _folder = folder;

    /// <summary>Path of the profile for the headset, which <see cref="LatencyProfileFile"/> reads.</summary>
    public string ProfilePath => Path.Combine(_folder, "profile.json");

    public string PagePath => Path.Combine(_folder, "calibration.html");

    /// <summary>Path of a new profile that has no render time limit, used when the existing profile has one.</summary>
    public string UnlimitedProfilePath => Path.Combine(_folder, "profile-without-limit.json");

    /// <summary>Path of the table that <c>calibrate range</c> reads.</summary>
    public string PairsPath => Path.Combine(_folder, "pairs.csv");

    /// <summary>Creates the folder.</summary>
    /// <exception cref="InputException">The folder is not writable. This is checked before the work, not after it.</exception>
    public static CalibrationOutput At(string folder) => OutputPath.InFolder("--out", folder, full =>
    {
        var trial = Path.Combine(full, Path.GetRandomFileName());
        File.WriteAllText(trial, "");
        File.Delete(trial);
        return new CalibrationOutput(full);
    });

    /// <summary>Writes the profile and the page. An existing profile that has a limit is not replaced by one without a limit.</summary>
    /// <param name="profile">The profile, or null for none.</param>
    /// <returns>Path of the written profile, or null for none.</returns>
    public string Write(LatencyProfile profile, CalibrationPageData page)
    {
        File.WriteAllText(PagePath, CalibrationPage.Render(CalibrationJson.Of(page)));
        if (profile == null) return null;
        var path = profile.Range == null && EarlierLimit() is TimeSpan limit ? Beside(limit) : ProfilePath;
        LatencyProfileFile.Save(path, profile);
        return path;
    }

    public void WritePairs(IEnumerable<MeasuredPicture> pictures)
    {
        using var file = File.CreateText(PairsPath);
        file.Write("file,vertices,render_ms,visu_ms\n");
        foreach (var picture in pictures.Where(each => each.RenderMs.HasValue))
            file.Write(string.Create(
                CultureInfo.InvariantCulture, $"{Quoted(picture.File)},{picture.Vertices},{picture.RenderMs:0.####},{picture.VisuMs:0.####}\n"));
    }

    string Beside(TimeSpan limit)
    {
        Console.Error.WriteLine(ConsoleMessages.ProfileKept(ProfilePath, limit.TotalMilliseconds));
        return UnlimitedProfilePath;
    }

    // Null if there is no usable profile, or it has no limit.
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

    static string Quoted(string name) => name?.IndexOfAny([',', '"', '\n']) >= 0 ? '"' + name.Replace("\"", "\"\"", StringComparison.Ordinal) + '"' : name;
}
