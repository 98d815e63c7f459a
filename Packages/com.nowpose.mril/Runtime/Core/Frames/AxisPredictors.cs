using System;
using Nowpose.Prediction;
using Nowpose.Prediction.Forecasting;

namespace Nowpose.Frames
{
    /// <summary>Three predictors of one kind, for the components of a vector.</summary>
    sealed class AxisPredictors
    {
        // The first component is always predicted. Its drop reasons, time and horizon apply to the whole vector.
        readonly JointPredictor _x;
        readonly AxisPredictor _y, _z;

        /// <param name="create">Creates the predictor of one component.</param>
        /// <param name="skipsConstants">Whether a component needs no prediction before its first change.</param>
        public AxisPredictors(Func<JointPredictor> create, bool skipsConstants)
        {
            _x = create();
            _y = new AxisPredictor(create(), skipsConstants);
            _z = new AxisPredictor(create(), skipsConstants);
        }

        /// <summary>Vector of the newest sample; 0 before the first sample.</summary>
        public Vector3D Hold => new Vector3D(_x.Hold, _y.Hold, _z.Hold);

        /// <inheritdoc cref="JointPredictor.NewestTime"/>
        public double NewestTime => _x.NewestTime;

        /// <summary>Sum of the restarts of the three components.</summary>
        /// <inheritdoc cref="JointPredictor.Restarts"/>
        public int Restarts => _x.Restarts + _y.Restarts + _z.Restarts;

        /// <inheritdoc cref="JointPredictor.Horizon"/>
        public double Horizon => _x.Horizon;

        /// <summary>State of the first component's motion; its times and intervals are those of the whole vector.</summary>
        public MotionState Motion => _x.Motion;

        /// <summary>Adds a sample. Samples may be added in any order. For the parameters, see <see cref="JointPredictor.Add"/>.</summary>
        public DropReason Add(double time, in Vector3D position, double order, double displayed)
        {
            var reason = _x.Add(new JointSample(time, position.X, order), displayed);
            _y.Add(new JointSample(time, position.Y, order), displayed);
            _z.Add(new JointSample(time, position.Z, order), displayed);
            return reason;
        }

        public Vector3D At(double time) => new Vector3D(_x.At(time).Position, _y.At(time), _z.At(time));

        /// <summary>Returns how the vector at a given time is computed, for example interpolated or predicted.</summary>
        public PredictionKind KindAt(double time) => _x.At(time).Kind;

        public void Reset()
        {
            _x.Reset();
            _y.Reset();
            _z.Reset();
        }
    }
}
