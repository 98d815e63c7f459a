using System.Globalization;
using Nowpose.Latency;
using Nowpose.Web;

namespace Nowpose.Cli.Calibrate;

/// <summary>The folder a calibration writes to. What an earlier one left there stays until there is something better.</summary>
sealed class CalibrationOutput
{
    readonly string _folder;

    CalibrationOutput(string folder) => _folder = folder;

    /// <summary>For the headset: what <see cref="LatencyProfileFile"/> reads.</summary>
    public string ProfilePath => Path.Combine(_folder, "profile.json");

    public string PagePath => Path.Combine(_folder, "calibration.html");

    /// <summary>Where a profile goes that has no limit of the render time while the one that is there has one.</summary>
    public string UnlimitedProfilePath => Path.Combine(_folder, "profile-without-limit.json");

    /// <summary>What <c>calibrate range</c> reads.</summary>
    public string PairsPath => Path.Combine(_folder, "pairs.csv");

    /// <summary>Makes the folder.</summary>
    /// <exception cref="InputException">It cannot be written to; better known before the work than after.</exception>
    public static CalibrationOutput At(string folder)
    {
        try
        {
            var output = new CalibrationOutput(Directory.CreateDirectory(folder).FullName);
            var trial = Path.Combine(output._folder, Path.GetRandomFileName());
            File.WriteAllText(trial, "");
            File.Delete(trial);
            return output;
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or ArgumentException or NotSupportedException)
        {
            throw new InputException($"--out: {folder}: cannot be written to: {e.Message.ReplaceLineEndings(" ")}", e);
        }
    }

    /// <summary>Writes both. A profile that is there stays, unless the new one is as good: where it has a limit and the new one none.</summary>
    /// <param name="profile">Null for none.</param>
    /// <returns>Where the profile is; null for none.</returns>
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
        Console.Error.WriteLine(FormattableString.Invariant(
            $"nowpose: {ProfilePath} has a limit of the render time, {limit.TotalMilliseconds:0.00} ms, and stays; ")
            + $"the new profile has none and is written beside it. For the new L_visu with that limit, vlc, sine and nudge take --profile {ProfilePath}");
        return UnlimitedProfilePath;
    }

    // Null, too, where what stands there is no profile that could be used.
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
