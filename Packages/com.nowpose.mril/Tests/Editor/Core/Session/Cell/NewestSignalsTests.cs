using System.Collections.Generic;
using System.Linq;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using Nowpose.Session.Cell;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Session.Cell
{
    public class NewestSignalsTests
    {
        readonly NewestSignals _newest = new NewestSignals();

        DropReason Keep(double seconds, double value, string name = "grip") => _newest.Keep(
            new ArrivedSignal(new SignalValue(name, value), ControlTime.FromSeconds(seconds), HeadsetTime.FromSeconds(seconds)));

        (double Arrival, double Value, bool IsAfterLostChange)[] Taken()
        {
            var taken = new List<ArrivedSignal>();
            _newest.Take(taken);
            return taken.Select(each => (each.Arrival.SinceEpoch.TotalSeconds, each.Value.Value, each.IsAfterLostChange)).ToArray();
        }

        [Test]
        public void Keep_RepeatedValue_KeepsTheFirstAndTheNewestMessage()
        {
            Assert.That(new[] { Keep(1, 5), Keep(2, 5), Keep(3, 5) }, Is.EqualTo(new[] { DropReason.None, DropReason.None, DropReason.SlowReader }));
            Assert.That(Taken(), Is.EqualTo(new[] { (1.0, 5.0, false), (3.0, 5.0, false) }));
            Assert.That(Taken(), Is.Empty);
        }

        [Test]
        public void Keep_OtherValue_KeepsOnlyThisValueAndThatAChangeWasLost()
        {
            Assert.That(new[] { Keep(1, 5), Keep(2, 6) }, Is.EqualTo(new[] { DropReason.None, DropReason.SlowReader }));
            Assert.That(Taken(), Is.EqualTo(new[] { (2.0, 6.0, true) }));
        }

        [Test]
        public void Keep_MoreSignalsThanAllowed_RefusesOnlyNewSignals()
        {
            for (var k = 0; k < ProtocolLimits.Signals; k++) Assert.That(Keep(1, k, "s" + k), Is.EqualTo(DropReason.None));

            Assert.That(Keep(2, 0, "one more"), Is.EqualTo(DropReason.TooManySignals));
            Assert.That(Keep(2, 0, "s0"), Is.EqualTo(DropReason.None));
            Assert.That(Taken(), Has.Length.EqualTo(ProtocolLimits.Signals + 1));
        }
    }
}
