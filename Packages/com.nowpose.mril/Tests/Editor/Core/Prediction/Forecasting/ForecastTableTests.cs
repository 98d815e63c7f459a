using System;
using Nowpose.Prediction.Forecasting;
using Nowpose.Prediction.State;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Prediction.Forecasting
{
    public class ForecastTableTests
    {
        [Test]
        public void PointsUpTo_TimesUpToTheHorizonCap_NoOtherPointIsRead(
            [Values(0.01, 0.05, 0.12, 0.25, 0.3, 0.4, 0.5, double.PositiveInfinity)] double horizonCap)
        {
            var table = new double[ForecastTable.Points];
            for (var point = ForecastTable.PointsUpTo(horizonCap); point < table.Length; point++) table[point] = double.NaN;

            for (var percent = 0; percent <= 100; percent++)
                Assert.That(new TableTime(Math.Min(horizonCap, 1) * percent / 100).Read(table, 0, 0, 1), Is.Zero, percent + " % of the cap");
        }

        [Test]
        public void Read_ForecasterWithoutATable_ReturnsTheValueOfItsTable([Values(0, 0.02, 0.05, 0.13, 0.33, 0.47, 0.5, 0.6)] double ahead)
        {
            var (forecaster, table, time) = (new Parabola(), new double[ForecastTable.Points], new TableTime(ahead));
            forecaster.Fill(table, 0, ForecastTable.Points, components: 1);

            Assert.That(time.Read(forecaster, 0), Is.EqualTo(time.Read(table, 0, 0, 1)));
        }

        sealed class Parabola : Forecaster
        {
            public override bool Solve(MotionState motion) => true;

            public override double At(double ahead, int component) => 0.3 * ahead + 2 * ahead * ahead;
        }
    }
}
