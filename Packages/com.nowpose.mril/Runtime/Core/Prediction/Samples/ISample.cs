namespace Nowpose.Prediction.Samples
{
    /// <summary>A sample with its stamp: the position of a joint, or the pose of an object with several components.</summary>
    interface ISample<TSample>
    {
        /// <summary>Stamp t_k, which may be wrong; in a <see cref="SampleHistory{TSample}"/> the corrected time. In s.</summary>
        double Time { get; }

        /// <summary>Sort key of the samples, s: equal to <see cref="Time"/> unless the stamp is wrong.</summary>
        double Order { get; }

        /// <summary>Number of components.</summary>
        int Components { get; }

        /// <summary>One component, in rad or m.</summary>
        double this[int component] { get; }

        /// <summary>Velocity reported by the source, per second; NaN if it is not reported.</summary>
        double Velocity { get; }

        /// <summary>Acceleration reported by the source, per second squared; NaN if it is not reported.</summary>
        double Acceleration { get; }

        /// <summary>Returns the same sample with a corrected stamp and sort key.</summary>
        TSample With(double time, double order);
    }
}
