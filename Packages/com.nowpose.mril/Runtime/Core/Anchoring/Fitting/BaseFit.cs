using System;
using System.Collections.Generic;
using Nowpose.Kinematics;

namespace Nowpose.Anchoring.Fitting
{
    /// <summary>
    /// The pose of the base that fits several markers best: the rigid transform that brings their places at the base to where they
    /// are seen, and turns them as they are seen, each by its weight.
    /// </summary>
    /// <remarks>
    /// With three markers or more that are apart, their positions say almost alone how the base is turned, since a position is known
    /// better than the angle of a print; with one, its angle does; with two, the positions say what they can. How far three are trusted
    /// to say it by their angles, too, is told by how well these fit.
    /// </remarks>
    static class BaseFit
    {
        /// <summary>What three markers say of how much prints are askew is itself uncertain; radians.</summary>
        const double LeastAskew = 0.1 * Math.PI / 180, MostAskew = 2 * Math.PI / 180;

        /// <param name="markers">At least one.</param>
        /// <param name="without">Index of one that is left out; −1 for none.</param>
        /// <returns>Base frame in the room frame.</returns>
        public static RigidTransform Of(IReadOnlyList<MarkerEstimate> markers, int without = -1)
        {
            const double Assumed = MarkerEstimate.PlacedRadians * MarkerEstimate.PlacedRadians;
            var first = Of(markers, without, Assumed);
            return Of(markers, without, AskewVariance(markers, without, first, Assumed));
        }

        /// <summary>How much the prints are really askew, by how their angles contradict their places.</summary>
        static double AskewVariance(IReadOnlyList<MarkerEstimate> markers, int without, in RigidTransform fitted, double assumed)
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
            // Of one or two, the places do not say how the base is turned.
            return count < 3 ? assumed : Math.Min(Math.Max(sum / count, LeastAskew * LeastAskew), MostAskew * MostAskew);
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

        /// <summary>By how much a marker is not where a base would have it.</summary>
        public static (double Metres, double Radians) Misfit(in RigidTransform fitted, in MarkerEstimate marker)
        {
            var expected = fitted * marker.InBase;
            return (expected.DistanceTo(marker.Mean), expected.AngleTo(marker.Mean));
        }

        static (double X, double Y, double Z) Add((double X, double Y, double Z) sum, in RigidTransform pose, double weight) =>
            (sum.X + weight * pose.X, sum.Y + weight * pose.Y, sum.Z + weight * pose.Z);

        static (double X, double Y, double Z) From((double X, double Y, double Z) centre, in RigidTransform pose) =>
            (pose.X - centre.X, pose.Y - centre.Y, pose.Z - centre.Z);
    }
}
