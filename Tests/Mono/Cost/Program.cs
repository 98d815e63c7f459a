using System;
using System.Diagnostics;
using System.Globalization;
using System.Linq;
using Nowpose.Prediction;

namespace Nowpose.Mono.Cost
{
    /// <summary>Measures the time per sample and per frame of seven joints with the default predictor and with the paper's quadratic.</summary>
    static class Program
    {
        /// <summary>
        /// Maximum ratio of the medians to those of the quadratic, which a busy machine slows down alike. On an idle machine they are about 15 and 2.
        /// </summary>
        const double MaxSampleRatio = 40, MaxFrameRatio = 8;

        /// <summary>Longer than any memory of the predictor, s.</summary>
        const double SecondsSeen = 130;

        static int Main()
        {
            Console.WriteLine("seven joints, a motion that repeats; µs");
            var isSlow = false;
            foreach (var intervalMs in new[] { 50, 10 }) isSlow |= !Compare(intervalMs);
            return isSlow ? 1 : 0;
        }

        static bool Compare(int intervalMs)
        {
            var (tried, quadratic) = (new Arm(Predictors.Default), new Arm("quadratic"));
            var first = (int)(SecondsSeen * 1000 / intervalMs);
            var collections = 0;
            for (var i = 0; i < first + Arm.Samples; i++)
            {
                if (i == first) collections = GC.CollectionCount(0);
                tried.Play(i, intervalMs / 1000.0, i - first);
                quadratic.Play(i, intervalMs / 1000.0, i - first);
            }
            collections = GC.CollectionCount(0) - collections;
            var (sampleRatio, frameRatio) = (Median(tried.SampleTimes) / Median(quadratic.SampleTimes), Median(tried.FrameTimes) / Median(quadratic.FrameTimes));
            Console.WriteLine(string.Format(CultureInfo.InvariantCulture,
                "every {0} ms: a sample {1}, {2:0.0} times the quadratic's; a frame {3}, {4:0.0} times; {5} garbage collections", intervalMs,
                Text(tried.SampleTimes), sampleRatio, Text(tried.FrameTimes), frameRatio, collections));
            var (whole, wholeOfQuadratic) = (PercentileOfWholeFrames(tried), PercentileOfWholeFrames(quadratic));
            Console.WriteLine(string.Format(CultureInfo.InvariantCulture,
                "  a frame that takes two samples, P99 {0:0.0}, {1:0.0} more than with the quadratic", whole, whole - wholeOfQuadratic));
            if (sampleRatio <= MaxSampleRatio && frameRatio <= MaxFrameRatio && collections == 0) return true;
            Console.WriteLine(string.Format(CultureInfo.InvariantCulture,
                "error: at most {0} times the quadratic's sample, {1} times its frame and no garbage collection are allowed",
                MaxSampleRatio, MaxFrameRatio));
            return false;
        }

        // At 60 frames and 100 samples a second a frame handles at most two samples.
        static double PercentileOfWholeFrames(Arm arm) => arm.FrameTimes.Skip(1)
            .Select((frame, i) => arm.SampleTimes[i] + arm.SampleTimes[i + 1] + frame).OrderBy(time => time).ElementAt(arm.FrameTimes.Length * 99 / 100);

        static double Median(double[] times) => times.OrderBy(time => time).ElementAt(times.Length / 2);

        static string Text(double[] times)
        {
            var sorted = times.OrderBy(time => time).ToArray();
            return string.Format(CultureInfo.InvariantCulture, "{0:0.00} (mean {1:0.00}, P99 {2:0.0}, worst {3:0})", sorted[sorted.Length / 2],
                sorted.Average(), sorted[sorted.Length * 99 / 100], sorted[sorted.Length - 1]);
        }

        /// <summary>One predictor for each of seven joints, and the times of their samples and frames, µs.</summary>
        sealed class Arm
        {
            public const int Samples = 3000;

            const int Joints = 7;
            const int FramesPerSample = 3;

            /// <summary>Time between the newest sample and the first frame that shows it, s.</summary>
            const double Latency = 0.1;

            readonly JointPredictor[] _predictors;
            readonly Stopwatch _watch = new Stopwatch();
            double _displayed = double.NaN;

            public Arm(string predictor) =>
                _predictors = Enumerable.Range(0, Joints).Select(_ => Predictors.Create(predictor, new PredictionLimits(), 0.014)).ToArray();

            public double[] SampleTimes { get; } = new double[Samples];

            public double[] FrameTimes { get; } = new double[Samples];

            /// <param name="measured">Index at which the times are stored; negative to store none.</param>
            public void Play(int sample, double interval, int measured)
            {
                var time = sample * interval;
                _watch.Restart();
                for (var joint = 0; joint < Joints; joint++)
                    _predictors[joint].Add(new JointSample(time, 1.5 * Math.Sin(2 * Math.PI * time / 6.4 + joint)), _displayed);
                var taken = _watch.Elapsed;
                _watch.Restart();
                for (var frame = 0; frame < FramesPerSample; frame++)
                {
                    _displayed = time + Latency + frame * interval / FramesPerSample;
                    for (var joint = 0; joint < Joints; joint++) _predictors[joint].At(_displayed);
                }
                if (measured < 0) return;
                SampleTimes[measured] = taken.TotalMilliseconds * 1000;
                FrameTimes[measured] = _watch.Elapsed.TotalMilliseconds * 1000 / FramesPerSample;
            }
        }
    }
}
