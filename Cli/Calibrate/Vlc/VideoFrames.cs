using System.ComponentModel;
using System.Diagnostics;
using System.Globalization;
using Nowpose.Vision;

namespace Nowpose.Cli.Calibrate.Vlc;

/// <summary>Reads the frames of a video with ffmpeg, which must be installed.</summary>
static class VideoFrames
{
    /// <summary>
    /// Names of the ffmpeg option that outputs each frame once, regardless of its time stamp: the current name, and the name before ffmpeg 5.1.
    /// </summary>
    static readonly string[] EachFrameOnce = ["-fps_mode", "-vsync"];

    const int Colours = 3;

    public static IEnumerable<PictureRequest> Of(string path) => Read(path).Select(frame => PictureRequest.Grey(frame.Width, frame.Height, frame.Bytes));

    /// <summary>
    /// Reads the frames in grey: each pixel has the value of its brightest colour channel. Each frame overwrites the bytes of the previous one.
    /// </summary>
    /// <exception cref="InputException">ffmpeg is missing or cannot read the file.</exception>
    public static IEnumerable<(int Width, int Height, byte[] Bytes)> Read(string path)
    {
        var (width, height) = SizeOf(path);
        foreach (var option in EachFrameOnce)
        {
            using var ffmpeg = Start(
                "ffmpeg",
                ["-v", "error", "-nostdin", "-noautorotate", "-i", path, "-f", "rawvideo", "-pix_fmt", "rgb24", option, "passthrough", "-"]);
            try
            {
                var errors = ffmpeg.StandardError.ReadToEndAsync();
                var frame = new byte[Colours * width * height];
                var grey = new byte[width * height];
                var count = 0;
                for (; ffmpeg.StandardOutput.BaseStream.ReadAtLeast(frame, frame.Length, throwOnEndOfStream: false) == frame.Length; count++)
                {
                    SetBrightest(frame, grey);
                    yield return (width, height, grey);
                }
                if (count > 0)
                {
                    WarnIfIncomplete(path, count, errors.Result);
                    yield break;
                }
                if (option == EachFrameOnce[^1] || !errors.Result.Contains(option[1..], StringComparison.Ordinal))
                    throw new InputException(PictureMessages.NoFramesByFfmpeg(path, errors.Result.Trim().ReplaceLineEndings(" ")));
            }
            finally
            {
                if (!ffmpeg.HasExited) ffmpeg.Kill();
            }
        }
    }

    // Takes the brightest colour channel instead of the luma, because the luma of a red or blue LED is only a small part of its light.
    static void SetBrightest(ReadOnlySpan<byte> colours, Span<byte> grey)
    {
        for (var i = 0; i < grey.Length; i++)
        {
            var pixel = colours.Slice(Colours * i, Colours);
            grey[i] = Math.Max(pixel[0], Math.Max(pixel[1], pixel[2]));
        }
    }

    // If ffmpeg reported an error, warns that the video is truncated or damaged and contains fewer pictures than were filmed.
    static void WarnIfIncomplete(string path, int count, string errors)
    {
        var first = errors.Split('\n', StringSplitOptions.RemoveEmptyEntries | StringSplitOptions.TrimEntries).FirstOrDefault();
        if (first != null) Console.Error.WriteLine(ConsoleMessages.FfmpegReports(path, count, first));
    }

    /// <summary>Gets the time of each frame, s. The frame rate of phones is not constant.</summary>
    /// <exception cref="InputException">ffmpeg is missing or cannot read the file.</exception>
    public static double[] TimesOf(string path)
    {
        var lines = Probed(path, "frame=best_effort_timestamp_time", out var errors);
        double[] times = [.. lines.Select(line => double.TryParse(line.TrimEnd(','), CultureInfo.InvariantCulture, out var time) ? time : double.NaN)];
        for (var i = 1; i < times.Length; i++)
            if (!(times[i] > times[i - 1])) throw new InputException(PictureMessages.FrameOrder(path, i + 1));
        return times.Length > 1 ? times : throw new InputException(PictureMessages.NoFrames(path, errors));
    }

    static (int Width, int Height) SizeOf(string path)
    {
        var words = Probed(path, "stream=width,height", out var errors).FirstOrDefault("").Split(',');
        if (words.Length >= 2 && int.TryParse(words[0], CultureInfo.InvariantCulture, out var width) && int.TryParse(words[1], CultureInfo.InvariantCulture, out var height)
            && width > 0 && height > 0)
            return (width, height);
        throw new InputException(PictureMessages.NoVideo(path, errors));
    }

    static string[] Probed(string path, string entries, out string errors)
    {
        using var ffprobe = Start("ffprobe", ["-v", "error", "-select_streams", "v:0", "-show_entries", entries, "-of", "csv=p=0", path]);
        var complaints = ffprobe.StandardError.ReadToEndAsync();
        var lines = ffprobe.StandardOutput.ReadToEnd().Split('\n', StringSplitOptions.RemoveEmptyEntries | StringSplitOptions.TrimEntries);
        errors = complaints.Result.Trim().ReplaceLineEndings(" ");
        return lines;
    }

    static Process Start(string program, string[] arguments)
    {
        try
        {
            return Process.Start(new ProcessStartInfo(program, arguments) { RedirectStandardOutput = true, RedirectStandardError = true });
        }
        catch (Win32Exception e)
        {
            throw new InputException(PictureMessages.FfmpegNeeded, e);
        }
    }
}
