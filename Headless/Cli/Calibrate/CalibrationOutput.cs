using System.Globalization;
using Nowpose.Cli.Calibrate.Page;
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

    /// <summary>The last profile with a limit of the render time that one without has replaced.</summary>
    public string LimitedProfilePath => Path.Combine(_folder, "profile-with-limit.json");

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

    /// <param name="profile">Null for none: one that is there stays. A limit that is there and that it has not is kept beside it.</param>
    public void Write(LatencyProfile profile, CalibrationPageData page)
    {
        if (profile != null)
        {
            if (profile.Range == null) KeepLimit();
            LatencyProfileFile.Save(ProfilePath, profile);
        }
        File.WriteAllText(PagePath, CalibrationPage.Render(CalibrationJson.Of(page)));
    }

    public void WritePairs(IEnumerable<MeasuredPicture> pictures)
    {
        using var file = File.CreateText(PairsPath);
        file.Write("file,vertices,render_ms,visu_ms\n");
        foreach (var picture in pictures.Where(each => each.RenderMs.HasValue))
            file.Write(string.Create(
                CultureInfo.InvariantCulture, $"{Quoted(picture.File)},{picture.Vertices},{picture.RenderMs:0.####},{picture.VisuMs:0.####}\n"));
    }

    void KeepLimit()
    {
        if (EarlierLimit() is not TimeSpan limit) return;
        File.Copy(ProfilePath, LimitedProfilePath, overwrite: true);
        Console.Error.WriteLine(FormattableString.Invariant(
            $"nowpose: the profile that was there has a limit of the render time, {limit.TotalMilliseconds:0.00} ms, and the new one none: ")
            + $"the earlier one is now {LimitedProfilePath}; vlc, sine and nudge take its limit over with --profile");
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
