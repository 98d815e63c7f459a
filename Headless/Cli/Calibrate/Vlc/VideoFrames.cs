using System.ComponentModel;
using System.Diagnostics;
using System.Globalization;
using Nowpose.Vision;

namespace Nowpose.Cli.Calibrate.Vlc;

/// <summary>A video's frames, by ffmpeg, which must be installed.</summary>
static class VideoFrames
{
    const string Needed = "ffmpeg and ffprobe are needed to read videos and were not found; install ffmpeg, or give pictures";

    /// <exception cref="InputException">ffmpeg is missing, or cannot read the file.</exception>
    public static IEnumerable<PictureRequest> Of(string path)
    {
        var (width, height) = SizeOf(path);
        using var ffmpeg = Start("ffmpeg", ["-v", "error", "-nostdin", "-noautorotate", "-i", path, "-f", "rawvideo", "-pix_fmt", "gray", "-fps_mode", "passthrough", "-"]);
        try
        {
            var errors = ffmpeg.StandardError.ReadToEndAsync();
            var frame = new byte[width * height];
            var count = 0;
            for (; ffmpeg.StandardOutput.BaseStream.ReadAtLeast(frame, frame.Length, throwOnEndOfStream: false) == frame.Length; count++)
                yield return PictureRequest.Grey(width, height, frame);
            if (count == 0) throw new InputException($"{path}: ffmpeg finds no frames in it: {errors.Result.Trim().ReplaceLineEndings(" ")}");
        }
        finally
        {
            if (!ffmpeg.HasExited) ffmpeg.Kill();
        }
    }

    static (int Width, int Height) SizeOf(string path)
    {
        using var ffprobe = Start("ffprobe", ["-v", "error", "-select_streams", "v:0", "-show_entries", "stream=width,height", "-of", "csv=p=0", path]);
        var errors = ffprobe.StandardError.ReadToEndAsync();
        var words = ffprobe.StandardOutput.ReadToEnd().Trim().Split(',');
        if (words.Length >= 2 && int.TryParse(words[0], CultureInfo.InvariantCulture, out var width) && int.TryParse(words[1], CultureInfo.InvariantCulture, out var height)
            && width > 0 && height > 0)
            return (width, height);
        throw new InputException($"{path}: ffprobe finds no video in it: {errors.Result.Trim().ReplaceLineEndings(" ")}");
    }

    static Process Start(string program, string[] arguments)
    {
        try
        {
            return Process.Start(new ProcessStartInfo(program, arguments) { RedirectStandardOutput = true, RedirectStandardError = true });
        }
        catch (Win32Exception e)
        {
            throw new InputException(Needed, e);
        }
    }
}
