using System.Collections.Generic;
using Nowpose.Protocol;
using Nowpose.Recording;
using Nowpose.Session;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Recording
{
    public class RecordRingTests
    {
        // The ring has thousands of records, and a message may have 64 KiB.
        [Test]
        public void Release_RecordOfAMessage_KeepsNoReferenceToIt()
        {
            var ring = new RecordRing(1, 1);
            var record = ring.TryClaim(RecordKind.Diagnostics);
            record.Diagnostics = new DiagnosticsMessage(default, "goggles", new List<KeyValuePair<string, string>>());
            record.SetSample(new Arrival<JointStateMessage>(new JointStateMessage(default, new[] { "a" }, new[] { 1.0 }), default), null, "arm/", DropReason.None);
            ring.Publish(record);
            Assert.That(ring.TryPeek(out var peeked), Is.True);
            Assert.That(peeked.Diagnostics, Is.Not.Null);

            ring.Release();

            Assert.That((record.Diagnostics, record.Arrival.Message, record.NamePrefix), Is.EqualTo(((DiagnosticsMessage)null, (JointStateMessage)null, (string)null)));
            Assert.That(ring.TryClaim(RecordKind.Sample), Is.SameAs(record));
        }
    }
}
