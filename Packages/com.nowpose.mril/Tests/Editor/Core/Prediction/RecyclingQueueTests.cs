using System.Linq;
using NUnit.Framework;
using Nowpose.Prediction.Mixing;

namespace Nowpose.Tests.Core.Prediction
{
    public class RecyclingQueueTests
    {
        const int Capacity = 3;

        sealed class Element
        {
            public int Value { get; set; }
        }

        [Test]
        public void Elements_Appended_AreInTheOrderOfTheirArrival()
        {
            Assert.That(Values(Filled(1, 2)), Is.EqualTo(new[] { 1, 2 }));
        }

        [Test]
        public void Append_WhenFull_DropsTheOldest()
        {
            Assert.That(Values(Filled(1, 2, 3, 4, 5)), Is.EqualTo(new[] { 3, 4, 5 }));
        }

        [Test]
        public void DropFirst_ThenAppend_KeepsTheOthersAndReusesTheDroppedElement()
        {
            var queue = Filled(1, 2, 3);
            var (first, second) = (queue[0], queue[1]);

            queue.DropFirst();
            queue.DropFirst();

            Assert.That(Values(queue), Is.EqualTo(new[] { 3 }));
            Assert.That(queue.Append(), Is.SameAs(second), "the element that was dropped last is reused");
            Assert.That(queue.Append(), Is.SameAs(first));
        }

        [Test]
        public void Clear_SomeElements_LeavesNone()
        {
            var queue = Filled(1, 2);

            queue.Clear();

            Assert.That(queue.Count, Is.Zero);
        }

        static RecyclingQueue<Element> Filled(params int[] values)
        {
            var queue = new RecyclingQueue<Element>(Capacity, () => new Element());
            foreach (var value in values) queue.Append().Value = value;
            return queue;
        }

        static int[] Values(RecyclingQueue<Element> queue) => Enumerable.Range(0, queue.Count).Select(i => queue[i].Value).ToArray();
    }
}
