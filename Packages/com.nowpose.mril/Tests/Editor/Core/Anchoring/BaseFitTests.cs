using System;
using System.Collections.Generic;
using MathNet.Numerics.LinearAlgebra;
using Nowpose.Anchoring;
using Nowpose.Anchoring.Fitting;
using Nowpose.Kinematics;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Anchoring
{
    public class BaseFitTests
    {
        const double Degree = Math.PI / 180;

        static readonly RigidTransform Base = RigidTransform.FromXyzRpy(3, -2, 0.5, 0.3, -0.8, 2.9);

        static readonly RigidTransform[] Places =
        {
            RigidTransform.FromXyzRpy(0.2, 0, 0, 0, 0, 0.4), RigidTransform.FromXyzRpy(-0.1, 0.15, 0, 0.5, 0, 2),
            RigidTransform.FromXyzRpy(-0.1, -0.15, 0.02, 0, -0.7, -1), RigidTransform.FromXyzRpy(0.4, 0.3, -0.2, 1, 1, 1),
        };

        static List<MarkerEstimate> Seen(int count, Func<int, RigidTransform> off = null, double errorRadians = 0.001)
        {
            var markers = new List<MarkerEstimate>();
            for (var i = 0; i < count; i++)
                markers.Add(new MarkerEstimate(
                    Places[i], Base * Places[i] * (off == null ? RigidTransform.Identity : off(i)), 0.001, errorRadians));
            return markers;
        }

        [TestCase(1)]
        [TestCase(2)]
        [TestCase(3)]
        [TestCase(4)]
        public void Of_WithoutNoise_ReturnsTheExactBase(int count)
        {
            var fitted = BaseFit.Of(Seen(count));

            Assert.That(fitted.DistanceTo(Base), Is.LessThan(1e-12));
            Assert.That(fitted.AngleTo(Base), Is.LessThan(1e-12));
        }

        [Test]
        public void Of_CollinearMarkers_DeterminesTheRotationAboutTheLine()
        {
            var markers = new List<MarkerEstimate>();
            for (var i = 0; i < 3; i++)
            {
                var place = RigidTransform.FromXyzRpy(0.2 * i, 0, 0, 0.1 * i, 0, 0);
                markers.Add(new MarkerEstimate(place, Base * place, 0.001, 0.001));
            }

            Assert.That(BaseFit.Of(markers).AngleTo(Base), Is.LessThan(1e-12));
        }

        [Test]
        public void Of_MarkersMovedTogether_MovesTheBaseEqually()
        {
            var random = new Random(4);
            RigidTransform Off(int _) =>
                PoseNumbers.Turn(random.NextDouble() / 50, random.NextDouble() / 50, 0).MovedTo(random.NextDouble() / 100, 0, 0);
            var markers = Seen(4, Off);
            var room = RigidTransform.FromXyzRpy(-1, 5, 2, 1, 2, 3);

            var there = BaseFit.Of(markers.ConvertAll(marker => marker.From(room)));

            Assert.That(there.DistanceTo(room * BaseFit.Of(markers)), Is.LessThan(1e-12));
            Assert.That(there.AngleTo(room * BaseFit.Of(markers)), Is.LessThan(1e-12));
        }

        // Angles with an uncertainty of more than 60° carry no information. The fit then equals the least-squares fit of the positions (Kabsch).
        [Test]
        public void Of_InaccurateAngles_EqualsTheFitToThePositions([Range(1, 10)] int seed)
        {
            var random = new Random(seed);
            double Some() => 0.02 * (random.NextDouble() - 0.5);
            var markers = Seen(4, _ => RigidTransform.Identity.MovedTo(Some(), Some(), Some()), errorRadians: 1e4);

            var fitted = BaseFit.Of(markers);

            var expected = Kabsch(markers);
            Assert.That(fitted.AngleTo(expected), Is.LessThan(1e-6), "seed " + seed);
            Assert.That(fitted.DistanceTo(expected), Is.LessThan(1e-6), "seed " + seed);
        }

        // Three markers in a plane also fit their mirror image. The fit must not return a reflection.
        [Test]
        public void Of_LargePositionErrors_ReturnsARotationNotAReflection([Range(1, 10)] int seed)
        {
            var random = new Random(seed);
            double Some() => random.NextDouble() - 0.5;
            var markers = Seen(3, _ => RigidTransform.Identity.MovedTo(Some(), Some(), Some()), errorRadians: 1e4);

            Assert.That(BaseFit.Of(markers).IsPose(), Is.True);
        }

        [Test]
        public void Of_OneOfThreeMarkersRotated_RotatesTheBaseOnlySlightly()
        {
            RigidTransform Askew(int i) => i == 1 ? PoseNumbers.Turn(0, 2 * Degree, 0) : RigidTransform.Identity;

            Assert.That(BaseFit.Of(Seen(1, i => PoseNumbers.Turn(0, 2 * Degree, 0))).AngleTo(Base), Is.EqualTo(2 * Degree).Within(1e-6));
            Assert.That(BaseFit.Of(Seen(3, Askew)).AngleTo(Base), Is.LessThan(0.3 * Degree));
        }

        static RigidTransform Kabsch(List<MarkerEstimate> markers)
        {
            var build = Matrix<double>.Build;
            var (from, to) = (build.Dense(3, markers.Count), build.Dense(3, markers.Count));
            for (var i = 0; i < markers.Count; i++)
            {
                from.SetColumn(i, new[] { markers[i].InBase.X, markers[i].InBase.Y, markers[i].InBase.Z });
                to.SetColumn(i, new[] { markers[i].Mean.X, markers[i].Mean.Y, markers[i].Mean.Z });
            }
            Vector<double> here = from.RowSums() / markers.Count, there = to.RowSums() / markers.Count;
            for (var i = 0; i < markers.Count; i++)
            {
                from.SetColumn(i, from.Column(i) - here);
                to.SetColumn(i, to.Column(i) - there);
            }
            var svd = (to * from.Transpose()).Svd();
            var sign = Math.Sign((svd.U * svd.VT).Determinant());
            var r = svd.U * build.DenseOfDiagonalArray(new[] { 1.0, 1, sign }) * svd.VT;
            var t = there - r * here;
            return new RigidTransform(
                r[0, 0], r[0, 1], r[0, 2], r[1, 0], r[1, 1], r[1, 2], r[2, 0], r[2, 1], r[2, 2], t[0], t[1], t[2]);
        }
    }
}
