using System;
using System.Diagnostics;
using System.Globalization;
using System.Linq;
using Nowpose.Motion;
using Nowpose.Prediction;
using Nowpose.Prediction.Mixing;

namespace Nowpose.Mono.Cost
{
    /// <summary>
    /// Measures the time per sample and per frame of seven joints with the default predictor and with the paper's quadratic predictor.
    /// </summary>
    /// <remarks>
    /// Each run repeats the same samples with new predictors, and the time of each sample is its minimum over the runs. Therefore the
    /// percentiles show which samples cost more than others, independent of other load on the machine. The two predictors take turns, because the
    /// speed of a machine can change by a factor of two within a second.
    /// </remarks>
    static class Program
    {
        const int Runs = 4;

        /// <summary>Number of samples of a run, and of those after which the other predictor continues, about 3 ms.</summary>
        const int Samples = 3000, Turn = 50;

        /// <summary>Maximum ratios of the medians to the medians of the quadratic predictor. The measured ratios are 5.7 to 9.0, and 0.8.</summary>
        const double MaxSampleRatio = 12, MaxFrameRatio = 2;

        /// <summary>
        /// Maximum increase of the 99th percentile of a whole frame over that of the quadratic predictor, relative to the median sample of the
        /// latter. The measured ratios are 10 to 23: 60 to 136 µs, depending on the speed of the machine.
        /// </summary>
        const double MaxIncreaseRatio = 30;

        /// <summary>Frames per second of a headset.</summary>
        const double FrameRate = 60;

        static readonly SevenPhaseProfile Forth = new SevenPhaseProfile(1, 1.5, 8, 80);

        static int Main()
        {
            Console.WriteLine("seven joints, a motion that repeats; µs");
            var isSlow = false;
            foreach (var intervalMs in new[] { 50, 10 }) isSlow |= !Compare(intervalMs, new PredictionLimits(), Wave);
            Console.WriteLine("moves of drives with known limits");
            isSlow |= !Compare(50, new PredictionLimits(velocity: 1.5, acceleration: 8, jerk: 80), Move);
            return isSlow ? 1 : 0;
        }

        static double Wave(double time, int joint) => 1.5 * Math.Sin(2 * Math.PI * time / 6.4 + joint);

        // All joints brake at the same time, which is the case with the highest cost.
        static double Move(double time, int joint)
        {
            var phase = time % 4;
            return phase < 2 ? Forth.PositionAt(phase) : 1 - Forth.PositionAt(phase - 2);
        }

        static bool Compare(int intervalMs, PredictionLimits limits, Func<double, int, double> motion)
        {
            var (tried, quadratic) = (new Arm(Predictors.Default, limits, motion), new Arm("quadratic", limits, motion));
            var collections = 0;
            for (var run = 0; run < Runs; run++)
            {
                tried.Begin(intervalMs / 1000.0);
                quadratic.Begin(intervalMs / 1000.0);
                var before = GC.CollectionCount(0);
                for (var first = 0; first < Samples; first += Turn)
                {
                    tried.Play(first);
                    quadratic.Play(first);
                }
                collections = GC.CollectionCount(0) - before;
            }
            var unit = Median(quadratic.SampleTimes);
            var (sampleRatio, frameRatio) = (Median(tried.SampleTimes) / unit, Median(tried.FrameTimes) / Median(quadratic.FrameTimes));
            Console.WriteLine(string.Format(CultureInfo.InvariantCulture,
                "every {0} ms: a sample {1}, {2:0.0} times the quadratic's; a frame {3}, {4:0.0} times; {5} garbage collections", intervalMs,
                Text(tried.SampleTimes), sampleRatio, Text(tried.FrameTimes), frameRatio, collections));
            var samples = (int)Math.Ceiling(1000 / FrameRate / intervalMs);
            var whole = PercentileOfWholeFrames(tried, samples);
            var increase = whole - PercentileOfWholeFrames(quadratic, samples);
            Console.WriteLine(string.Format(CultureInfo.InvariantCulture,
                "  a frame that takes {0} sample(s), P99 {1:0.0}, {2:0.0} more than with the quadratic: {3:0.0} times its sample",
                samples, whole, increase, increase / unit));
            if (sampleRatio <= MaxSampleRatio && frameRatio <= MaxFrameRatio && increase <= MaxIncreaseRatio * unit && collections == 0) return true;
            Console.WriteLine(string.Format(CultureInfo.InvariantCulture,
                "error: at most {0} times the quadratic's sample, {1} times its frame, {2} times its sample more per whole frame and no garbage "
                + "collection are allowed", MaxSampleRatio, MaxFrameRatio, MaxIncreaseRatio));
            return false;
        }

        static double PercentileOfWholeFrames(Arm arm, int samples) => arm.FrameTimes.Skip(samples)
            .Select((frame, i) => arm.SampleTimes.Skip(i).Take(samples).Sum() + frame).OrderBy(time => time).ElementAt((arm.FrameTimes.Length - samples) * 99 / 100);

        static double Median(double[] times) => times.OrderBy(time => time).ElementAt(times.Length / 2);

        static string Text(double[] times)
        {
            var sorted = times.OrderBy(time => time).ToArray();
            return string.Format(CultureInfo.InvariantCulture, "{0:0.00} (mean {1:0.00}, P99 {2:0.0}, worst {3:0})", sorted[sorted.Length / 2],
                sorted.Average(), sorted[sorted.Length * 99 / 100], sorted[sorted.Length - 1]);
        }

        /// <summary>Measures the computation times of one predictor for seven joints, per sample and per frame, in µs.</summary>
        sealed class Arm
        {
            const int Joints = 7;
            const int FramesPerSample = 3;

            /// <summary>Time in s before the measured samples. It is longer than the history that any predictor uses.</summary>
            const double SecondsSeen = 130;

            /// <summary>Time between the newest sample and the first frame that shows it, s.</summary>
            const double Latency = 0.1;

            readonly string _predictor;
            readonly PredictionLimits _limits;
            readonly Func<double, int, double> _motion;
            readonly Stopwatch _watch = new Stopwatch();
            JointPredictor[] _joints;
            double _interval, _displayed;
            int _seen;

            public Arm(string predictor, PredictionLimits limits, Func<double, int, double> motion)
            {
                (_predictor, _limits, _motion) = (predictor, limits, motion);
                Array.Fill(SampleTimes, double.PositiveInfinity);
                Array.Fill(FrameTimes, double.PositiveInfinity);
            }

            public double[] SampleTimes { get; } = new double[Samples];

            public double[] FrameTimes { get; } = new double[Samples];

            /// <summary>Begins a run with new predictors and plays the time before the measured samples.</summary>
            public void Begin(double interval)
            {
                var forecasters = Predictors.ForecastersOfJoints();
                _joints = Enumerable.Range(0, Joints).Select(_ => Predictors.Create(_predictor, _limits, 0.014, forecasters)).ToArray();
                (_interval, _displayed, _seen) = (interval, double.NaN, (int)(SecondsSeen / interval));
                for (var i = 0; i < _seen; i++) Play(i * interval, out _, out _);
            }

            /// <summary>Measures the samples of one turn.</summary>
            public void Play(int first)
            {
                for (var i = first; i < first + Turn; i++)
                {
                    Play((_seen + i) * _interval, out var sample, out var frame);
                    SampleTimes[i] = Math.Min(SampleTimes[i], sample);
                    FrameTimes[i] = Math.Min(FrameTimes[i], frame);
                }
            }

            void Play(double time, out double sample, out double frame)
            {
                _watch.Restart();
                for (var joint = 0; joint < Joints; joint++)
                    _joints[joint].Add(new JointSample(time, _motion(time, joint)), _displayed);
                sample = _watch.Elapsed.TotalMilliseconds * 1000;
                _watch.Restart();
                for (var i = 0; i < FramesPerSample; i++)
                {
                    _displayed = time + Latency + i * _interval / FramesPerSample;
                    for (var joint = 0; joint < Joints; joint++) _joints[joint].At(_displayed);
                }
                frame = _watch.Elapsed.TotalMilliseconds * 1000 / FramesPerSample;
            }
        }
    }
}
