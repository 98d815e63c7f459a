using System;
using System.Linq;
using Nowpose.Editor;
using Nowpose.Editor.Inspectors;
using NUnit.Framework;

namespace Nowpose.Tests.Unity.Inspectors
{
    public class RollingSeriesTests
    {
        [Test]
        public void Add_WithinTheWindow_KeepsAllValuesOldestFirst()
        {
            var series = new RollingSeries(capacity: 10, seconds: 5);
            for (var i = 0; i < 4; i++) series.Add(i, 10 * i);

            Assert.That(Values(series), Is.EqualTo(new float[] { 0, 10, 20, 30 }));
            Assert.That(series.TimeAt(0), Is.EqualTo(0));
            Assert.That(series.Newest, Is.EqualTo(30));
        }

        [Test]
        public void Add_BeyondTheWindow_DropsOldValues()
        {
            var series = new RollingSeries(capacity: 100, seconds: 5);
            for (var i = 0; i <= 20; i++) series.Add(i, i);

            Assert.That(Values(series), Is.EqualTo(new float[] { 15, 16, 17, 18, 19, 20 }));
        }

        [Test]
        public void Add_BeyondTheCapacity_DropsTheOldestValues()
        {
            var series = new RollingSeries(capacity: 3, seconds: 100);
            for (var i = 0; i < 10; i++) series.Add(i, i);

            Assert.That(Values(series), Is.EqualTo(new float[] { 7, 8, 9 }));
        }

        [Test]
        public void Add_EarlierTime_Restarts()
        {
            var series = new RollingSeries(capacity: 10, seconds: 5);
            series.Add(100, 1);
            series.Add(2, 7);

            Assert.That(Values(series), Is.EqualTo(new float[] { 7 }));
        }

        [Test]
        public void TryGetRange_SomeUnknownValues_CoversTheKnownValues()
        {
            var series = new RollingSeries(capacity: 10, seconds: 5);
            foreach (var value in new double?[] { null, 3, -2, null }) series.Add(series.Count, value);

            Assert.That(series.TryGetRange(out var min, out var max));
            Assert.That(min, Is.EqualTo(-2));
            Assert.That(max, Is.EqualTo(3));
            Assert.That(series.Newest, Is.NaN);
        }

        [Test]
        public void TryGetRange_OnlyUnknownValues_ReturnsFalse()
        {
            var series = new RollingSeries(capacity: 10, seconds: 5);
            Assert.That(series.TryGetRange(out _, out _), Is.False);

            series.Add(0, null);

            Assert.That(series.TryGetRange(out _, out _), Is.False);
        }

        [TestCase(1, 5)]
        [TestCase(10, 0)]
        [TestCase(10, double.NaN)]
        public void Constructor_InvalidCapacityOrWindow_Throws(int capacity, double seconds)
        {
            Assert.Throws<ArgumentOutOfRangeException>(() => new RollingSeries(capacity, seconds));
        }

        static float[] Values(RollingSeries series) => Enumerable.Range(0, series.Count).Select(series.ValueAt).ToArray();
    }
}
