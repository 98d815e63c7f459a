using System.CommandLine;
using System.Globalization;
using System.Runtime.InteropServices;
using Nowpose.Cli;
using Nowpose.Gateway.Options;
using Nowpose.Prediction;

namespace Nowpose.Benchmarks.Cell;

/// <summary>cell: measures the CPU time of a display frame with many tracked objects and two robots.</summary>
static class CellVerb
{
    const int Objects = 50, FramesPerSecond = 60;

    const double MaxMilliseconds = 0.3;

    /// <summary>Sampling interval to which the limit applies, ms. It is the interval of the gateway's simulated sources.</summary>
    const int LimitedSamplingMs = 50;

    static readonly (bool IsPlane, int SamplingMs)[] Rows = [(true, LimitedSamplingMs), (false, LimitedSamplingMs), (true, 20), (false, 20)];

    public static Command Create()
    {
        var command = new Command("cell", $"Measure a frame with {Objects} tracked objects and two robots in the stand-in engine, in virtual time; Linux only");
        var seconds = NumberOption.Create("--seconds", "Virtual duration of each measurement", 60, 1, 3600, "s");
        var warmUp = NumberOption.Create(
            "--warm-up-s", "Virtual duration of the warm-up; a frame costs less until it exceeds the history of template matching", 130, 1, 3600, "s");
        command.Options.Add(seconds);
        command.Options.Add(warmUp);
        command.SetAction((parsed, stop) => Task.FromResult(Run(parsed.GetValue(warmUp), parsed.GetValue(seconds), stop)));
        return command;
    }

    static int Run(int warmUpSeconds, int seconds, CancellationToken stop)
    {
        (double Mean, double Median, double WithSamples, long Bytes) Measured(int objects, bool isPlane, int samplingMs, string predictor)
        {
            using var scene = new ObjectScene(objects, isPlane, samplingMs / 1000.0, predictor);
            return Measure(scene, warmUpSeconds, seconds, stop);
        }

        var table = new MarkdownTable(
            Console.Out, "motion", "samples every", "mean", "median", "frames with samples", "no objects", "quadratic", "allocated");
        var missed = new List<string>();
        foreach (var (isPlane, samplingMs) in Rows)
        {
            var cost = Measured(Objects, isPlane, samplingMs, Predictors.Default);
            var (robots, quadratic) = (Measured(0, isPlane, samplingMs, Predictors.Default), Measured(Objects, isPlane, samplingMs, "quadratic"));
            var motion = isPlane ? "in a plane" : "six coordinates";
            table.Add(
                $"{motion} | {samplingMs} ms | {cost.Mean:0} µs | {cost.Median:0} µs | {cost.WithSamples:0} µs",
                $"{robots.Mean:0} µs | {quadratic.Mean:0} µs | {cost.Bytes} B");
            if (samplingMs == LimitedSamplingMs && !(cost.Mean < 1000 * MaxMilliseconds))
                missed.Add(Text($"{motion}, samples every {samplingMs} ms: a frame takes {cost.Mean / 1000:0.00} ms; allowed: less than {MaxMilliseconds} ms"));
            if (cost.Bytes != 0) missed.Add($"{motion}, samples every {samplingMs} ms: {seconds} s of frames allocate {cost.Bytes} B; allowed: none");
        }

        Console.WriteLine();
        Console.WriteLine(Text(
            $"CPU time of the thread per frame at {FramesPerSecond} Hz, with the samples that arrive in it: {Objects} objects and two robots, the whole player loop of the stand-in engine. {RuntimeInformation.FrameworkDescription}, {DateTime.UtcNow:yyyy-MM-dd}."));
        foreach (var line in missed) Console.Error.WriteLine("error: " + line);
        return missed.Count == 0 ? ExitStatus.Done : ExitStatus.Failed;
    }

    // Returns times in µs, and the bytes that all measured frames allocated.
    static (double Mean, double Median, double WithSamples, long Bytes) Measure(ObjectScene scene, int warmUpSeconds, int seconds, CancellationToken stop)
    {
        for (var i = 0; i < warmUpSeconds * FramesPerSecond; i++) scene.Play(out _);
        if (!scene.IsCurrent) throw new InvalidOperationException("an object or a robot is not shown where it is");
        var (all, withSamples, bytes) = (new List<double>(), new List<double>(), 0L);
        for (var i = 0; i < seconds * FramesPerSecond; i++)
        {
            stop.ThrowIfCancellationRequested();
            var (spent, allocated) = scene.Play(out var hasSamples);
            all.Add(spent * 1e6);
            if (hasSamples) withSamples.Add(spent * 1e6);
            bytes += allocated;
        }

        return (all.Average(), Quantile.Of(all, 0.5), withSamples.Average(), bytes);
    }

    static string Text(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);
}
