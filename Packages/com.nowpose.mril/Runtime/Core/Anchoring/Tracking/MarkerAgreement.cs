using System;
using System.Collections.Generic;
using Nowpose.Anchoring.Fitting;
using Nowpose.Kinematics;

namespace Nowpose.Anchoring.Tracking
{
    /// <summary>
    /// Result of the check whether the observed relative poses of markers agree with their configured poses. If not, it identifies the
    /// wrong marker, if possible.
    /// </summary>
    readonly struct MarkerAgreement
    {
        /// <summary>
        /// Fraction of a marker's position error that appears in its own misfit. A fit distributes the error among the markers, for example half to
        /// each of two markers. An angle error of a print appears completely in its own misfit, because mainly the positions determine the rotation
        /// of the base.
        /// </summary>
        const double Shared = 0.5;

        /// <summary>
        /// Factors by which the tolerances are multiplied, because the configured pose of a print is less accurate than the measurement of a later
        /// movement.
        /// </summary>
        public const double MetresFactor = 2, AngleFactor = 4;

        MarkerAgreement(bool isGood, int wrong, in RigidTransform fitted, double metres, double radians) =>
            (IsGood, Wrong, Fitted, Metres, Radians) = (isGood, wrong, fitted, metres, radians);

        public bool IsGood { get; }

        /// <summary>Index of the marker that the other markers contradict; −1 if there is none or if it cannot be determined.</summary>
        public int Wrong { get; }

        /// <summary>Pose of the base fitted to all markers, except the wrong marker if there is one.</summary>
        public RigidTransform Fitted { get; }

        /// <summary>Deviation of the wrong marker, or of the markers from each other if the wrong marker is unknown, in metres.</summary>
        public double Metres { get; }

        public double Radians { get; }

        /// <param name="markers">One marker or more.</param>
        public static MarkerAgreement Of(IReadOnlyList<MarkerEstimate> markers, AnchoringSettings settings)
        {
            var all = BaseFit.Of(markers);
            var isEachGood = WorstMisfit(markers, all, -1, settings) <= 1;
            if (isEachGood && TurnMisfit(markers, all, -1, settings) <= 1) return new MarkerAgreement(true, -1, all, 0, 0);
            // If only the common turn is too large, either the position of one marker or the angles of all markers may be wrong.
            if (!isEachGood && markers.Count > 2)
            {
                int wrong = -1;
                var (min, fitted) = (double.PositiveInfinity, all);
                for (var i = 0; i < markers.Count; i++)
                {
                    var others = BaseFit.Of(markers, without: i);
                    var rest = Math.Max(WorstMisfit(markers, others, i, settings), TurnMisfit(markers, others, i, settings));
                    if (rest < min) (min, wrong, fitted) = (rest, i, others);
                }
                if (min <= 1)
                {
                    var (off, turned) = BaseFit.Misfit(fitted, markers[wrong]);
                    return new MarkerAgreement(false, wrong, fitted, off, turned);
                }
            }
            double metres = 0, radians = 0;
            foreach (var marker in markers)
            {
                var misfit = BaseFit.Misfit(all, marker);
                metres = Math.Max(metres, misfit.Metres / Shared);
                radians = Math.Max(radians, misfit.Radians);
            }
            return new MarkerAgreement(false, -1, all, metres, radians);
        }

        /// <summary>Returns the common turn of the prints relative to the allowed turn.</summary>
        static double TurnMisfit(IReadOnlyList<MarkerEstimate> markers, in RigidTransform fitted, int without, AnchoringSettings settings)
        {
            // The tilts of prints are independent of each other, so their mean is smaller than each of them. An error that the device makes in all
            // angles does not become smaller with the count, so the limit is that of three markers at least.
            var count = Math.Min(without < 0 ? markers.Count : markers.Count - 1, 3);
            return BaseFit.MeanTurn(fitted, markers, without) * Math.Sqrt(count) / (AngleFactor * settings.ToleranceRadians);
        }

        /// <summary>Returns the maximum misfit of a single marker relative to the allowed misfit.</summary>
        static double WorstMisfit(IReadOnlyList<MarkerEstimate> markers, in RigidTransform fitted, int without, AnchoringSettings settings)
        {
            double worst = 0;
            for (var i = 0; i < markers.Count; i++)
            {
                if (i == without) continue;
                var (metres, radians) = BaseFit.Misfit(fitted, markers[i]);
                worst = Math.Max(worst, metres / (Shared * MetresFactor * settings.ToleranceMetres));
                worst = Math.Max(worst, radians / (AngleFactor * settings.ToleranceRadians));
            }
            return worst;
        }
    }
}
