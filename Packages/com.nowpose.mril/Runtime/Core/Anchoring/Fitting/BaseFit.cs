using System;
using System.Collections.Generic;
using Nowpose.Kinematics;

namespace Nowpose.Anchoring.Fitting
{
    /// <summary>
    /// Fits the pose of the base to several markers: the rigid transform that maps their configured poses in the base frame to their
    /// measured poses, with weights for positions and rotations.
    /// </summary>
    /// <remarks>
    /// With three or more separate markers, mainly their positions determine the rotation of the base, because a position is measured more
    /// accurately than the angle of a print. With one marker, its angle determines the rotation; with two markers, their positions and
    /// their angles contribute. With three or more, the weight of the angles depends on how well they fit.
    /// </remarks>
    static class BaseFit
    {
        /// <summary>Limits of the estimated angle error of the prints, rad. An estimate from only three markers is uncertain.</summary>
        const double MinTiltError = 0.1 * Math.PI / 180, MaxTiltError = 2 * Math.PI / 180;

        /// <param name="markers">One marker or more.</param>
        /// <param name="without">Index of a marker to omit; −1 to use all markers.</param>
        /// <returns>Base frame in the room frame.</returns>
        public static RigidTransform Of(IReadOnlyList<MarkerEstimate> markers, int without = -1)
        {
            const double Assumed = MarkerEstimate.PlacedRadians * MarkerEstimate.PlacedRadians;
            var first = Of(markers, without, Assumed);
            return Of(markers, without, TiltVariance(markers, without, first, Assumed));
        }

        /// <summary>Estimates the variance of the prints' angle errors, rad², from the deviations of the angles from the fitted base.</summary>
        static double TiltVariance(IReadOnlyList<MarkerEstimate> markers, int without, in RigidTransform fitted, double assumed)
        {
            double sum = 0;
            var count = 0;
            for (var i = 0; i < markers.Count; i++)
            {
                if (i == without) continue;
                var (_, radians) = Misfit(fitted, markers[i]);
                sum += radians * radians / 3 - markers[i].RotationVariance;
                count++;
            }
            // The positions of one or two markers do not determine the rotation of the base.
            return count < 3 ? assumed : Math.Min(Math.Max(sum / count, MinTiltError * MinTiltError), MaxTiltError * MaxTiltError);
        }

        static RigidTransform Of(IReadOnlyList<MarkerEstimate> markers, int without, double placedVariance)
        {
            double sum = 0;
            (double X, double Y, double Z) there = default, here = default;
            for (var i = 0; i < markers.Count; i++)
            {
                if (i == without) continue;
                var weight = markers[i].PositionWeight;
                sum += weight;
                there = Add(there, markers[i].InBase, weight);
                here = Add(here, markers[i].Mean, weight);
            }
            there = (there.X / sum, there.Y / sum, there.Z / sum);
            here = (here.X / sum, here.Y / sum, here.Z / sum);

            var fit = new RotationFit();
            for (var i = 0; i < markers.Count; i++)
            {
                if (i == without) continue;
                fit.Add(markers[i].Mean * markers[i].InBase.Inverse, markers[i].RotationWeight(placedVariance));
                fit.Add(From(there, markers[i].InBase), From(here, markers[i].Mean), markers[i].PositionWeight);
            }
            var rotation = fit.Solve();
            var moved = rotation * RigidTransform.Identity.MovedTo(there.X, there.Y, there.Z);
            return rotation.MovedTo(here.X - moved.X, here.Y - moved.Y, here.Z - moved.Z);
        }

        /// <summary>Returns the deviation of a marker from its pose according to the fitted base.</summary>
        public static (double Metres, double Radians) Misfit(in RigidTransform fitted, in MarkerEstimate marker)
        {
            var expected = fitted * marker.InBase;
            return (expected.DistanceTo(marker.Mean), expected.AngleTo(marker.Mean));
        }

        /// <summary>Returns the mean angle by which the prints, each by its own angle, turn the base relative to the fitted base, in rad.</summary>
        /// <remarks>
        /// With several markers, mainly their positions determine the rotation, so this is the difference between what the positions and what the
        /// prints show.
        /// </remarks>
        public static double MeanTurn(in RigidTransform fitted, IReadOnlyList<MarkerEstimate> markers, int without = -1)
        {
            var (back, sum, count) = (fitted.Inverse, default(Vector3D), 0);
            for (var i = 0; i < markers.Count; i++)
            {
                if (i == without) continue;
                sum += (back * markers[i].Mean * markers[i].InBase.Inverse).RotationVector();
                count++;
            }
            return sum.Length / count;
        }

        static (double X, double Y, double Z) Add((double X, double Y, double Z) sum, in RigidTransform pose, double weight) =>
            (sum.X + weight * pose.X, sum.Y + weight * pose.Y, sum.Z + weight * pose.Z);

        static (double X, double Y, double Z) From((double X, double Y, double Z) centre, in RigidTransform pose) =>
            (pose.X - centre.X, pose.Y - centre.Y, pose.Z - centre.Z);
    }
}
