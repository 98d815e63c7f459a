using Nowpose.Pairing;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Pairing
{
    public class PairingCodeTests
    {
        [TestCase(null, PairingCodeKind.Foreign)]
        [TestCase("", PairingCodeKind.Foreign)]
        [TestCase("https://nowpose:cell/1", PairingCodeKind.Foreign)]
        [TestCase("nowpose", PairingCodeKind.Foreign)]
        [TestCase("nowpose:", PairingCodeKind.Unknown)]
        [TestCase("nowpose:cell", PairingCodeKind.Unknown)]
        [TestCase("nowpose:cells/1?", PairingCodeKind.Unknown)]
        [TestCase("NOWPOSE:x", PairingCodeKind.Unknown)]
        [TestCase("nowpose:cell/", PairingCodeKind.Cell)]
        [TestCase("nowpose:cell/7?q=1", PairingCodeKind.Cell)]
        [TestCase("nowpose:token/1?", PairingCodeKind.Token)]
        public void KindOf_Text_DependsOnItsPrefix(string text, object kind) => Assert.That(PairingCode.KindOf(text), Is.EqualTo((PairingCodeKind)kind));
    }
}
