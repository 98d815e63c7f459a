using System.Diagnostics;
using System.Globalization;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Calibrate.Pictures;

/// <summary>Base class of tests with videos. Replaces ffmpeg and ffprobe with scripts that output the pictures drawn by the test.</summary>
/// <remarks>The scripts are added to the path of this process. This does not affect tests that run meanwhile: they start other programs.</remarks>
[Platform(Exclude = "Win", Reason = "the stand-ins are shell scripts")]
public abstract class VideoFolder : CalibrationFolder
{
    string _path;

    [SetUp]
    public void RememberPath()
    {
        // RestorePath also runs if the test is ignored.
        _path = Environment.GetEnvironmentVariable("PATH");
        Needs.Vision();
    }

    [TearDown]
    public void RestorePath() => Environment.SetEnvironmentVariable("PATH", _path);

    /// <summary>
    /// Path of the file with the raw pictures, in the format of ffmpeg's output: red, green and blue of each pixel, one picture after the other.
    /// </summary>
    protected string FramesPath => Path.Combine(Folder, "frames.rgb");

    /// <returns>Path of the video.</returns>
    /// <param name="frames">Grey values of each picture, row by row.</param>
    /// <param name="times">Time of each picture, s.</param>
    /// <param name="colour">Relative intensities of red, green and blue.</param>
    protected string Video(string name, int width, int height, IEnumerable<byte[]> frames, IEnumerable<double> times, double[] colour = null)
    {
        using (var raw = File.Create(FramesPath))
            foreach (var frame in frames) raw.Write(InColour(frame, colour ?? [1, 1, 1]));
        File.WriteAllLines(Path.Combine(Folder, "times"), times.Select(time => time.ToString("0.000000", CultureInfo.InvariantCulture)));
        Script("ffmpeg", $"cat '{FramesPath}'");
        Script("ffprobe", $"case \"$*\" in *stream=*) echo {width},{height};; *) cat '{Path.Combine(Folder, "times")}';; esac");
        Environment.SetEnvironmentVariable("PATH", Path.Combine(Folder, "bin") + Path.PathSeparator + _path);
        return Write(name, ["a stand-in reads it"]);
    }

    static byte[] InColour(byte[] grey, double[] colour)
    {
        var pixels = new byte[colour.Length * grey.Length];
        for (var channel = 0; channel < colour.Length; channel++)
        {
            var share = colour[channel];
            for (int i = 0, at = channel; i < grey.Length; i++, at += colour.Length) pixels[at] = (byte)(share * grey[i]);
        }
        return pixels;
    }

    /// <summary>Replaces a program with a short shell script.</summary>
    /// <remarks>
    /// Another process writes the script. Linux does not run a file that is open for writing, and programs that other tests start meanwhile inherit
    /// the files that this process has open.
    /// </remarks>
    protected void Script(string name, string command)
    {
        var text = Write(name + ".sh", ["#!/bin/sh", command]);
        var folder = Directory.CreateDirectory(Path.Combine(Folder, "bin")).FullName;
        using var installation = Process.Start("install", ["-m", "755", text, Path.Combine(folder, name)]);
        installation.WaitForExit();
        Assert.That(installation.ExitCode, Is.Zero, name);
    }
}
