using System;
using System.Collections.Generic;
using Nowpose.Prediction;
using Nowpose.Prediction.Planning;

namespace Nowpose.Tests.Core.Prediction
{
    /// <summary>A joint as a display uses it: each frame asks for its position, and each sample is added with the newest displayed time.</summary>
    sealed class DisplayedJoint
    {
        const double Latency = 0.1;

        double _displayed = double.NaN;
        int _next;
        JointSample? _underWay;

        public DisplayedJoint(JointPredictor predictor) => Predictor = predictor;

        public JointPredictor Predictor { get; }

        public DropReason Add(double time, double position) => Add(new JointSample(time, position));

        public DropReason Add(in JointSample sample) => Predictor.Add(sample, _displayed);

        public void Follow(JointPath path, double start) => Predictor.Follow(path, start, _displayed);

        public void DropPlan() => Predictor.Follow(null, 0, _displayed);

        /// <summary>Shows a frame at a control time, in s.</summary>
        public JointPrediction Show(double time)
        {
            _displayed = time;
            return Predictor.At(time);
        }

        /// <summary>Shows frames at a fixed interval. Samples arrive 100 ms after their time.</summary>
        /// <param name="sampleOf">
        /// Returns the sample with a number. It is called once for each number; the numbers start at 0 and continue over several calls of this
        /// method.
        /// </param>
        /// <param name="frame">Frame interval, s.</param>
        public List<(double At, JointPrediction Shown)> Play(Func<int, JointSample> sampleOf, double from, double to, double frame = 1 / 60.0)
        {
            var shown = new List<(double, JointPrediction)>();
            for (var i = 0; from + i * frame < to - 1e-9; i++)
            {
                var time = from + i * frame;
                while ((_underWay ??= sampleOf(_next++)).Order + Latency <= time + 1e-9)
                {
                    Add(_underWay.Value);
                    _underWay = null;
                }
                shown.Add((time, Show(time)));
            }
            return shown;
        }
    }
}
