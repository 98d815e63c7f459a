using NUnit.Framework;

namespace Nowpose.Tests.Core
{
    public class NowposeVersionTests
    {
        static readonly string[] Numbers = NowposeVersion.Text.Split('.');

        [Test]
        public void Fits_OtherPatchVersion_IsTrue() => Assert.That(NowposeVersion.Fits($"{Numbers[0]}.{Numbers[1]}.99"), Is.True);

        [TestCase(1, 0)]
        [TestCase(0, 1)]
        public void Fits_OtherMajorOrMinorVersion_IsFalse(int major, int minor)
        {
            var other = $"{int.Parse(Numbers[0]) + major}.{int.Parse(Numbers[1]) + minor}.0";

            Assert.That(NowposeVersion.Fits(other), Is.False);
            Assert.That(NowposeVersion.MismatchOf(other, "the gateway", "this headset"), Does.Contain(other).And.Contain(NowposeVersion.Text));
        }

        [TestCase("-rc.1")]
        [TestCase("+5ed38b99")]
        [TestCase("-rc.1+5ed38b99")]
        public void Fits_PreReleaseOrBuildSuffix_IsIgnored(string end)
        {
            Assert.That(NowposeVersion.Fits($"{Numbers[0]}.{Numbers[1]}.0{end}"), Is.True);
            Assert.That(NowposeVersion.Fits($"{Numbers[0]}.{int.Parse(Numbers[1]) + 1}.0{end}"), Is.False);
        }

        // Programs before version 0.2.0 report no version, and other rosbridge servers may report any string.
        [TestCase(null)]
        [TestCase("")]
        [TestCase("9")]
        [TestCase("9.9")]
        [TestCase("9.9.x")]
        [TestCase("9.9.9.9")]
        [TestCase("-9.9.9")]
        [TestCase("9.9.9-")]
        [TestCase("9.9.9-rc\n")]
        [TestCase("9.9.99999999999")]
        [TestCase("999999999999999999999999999999.9.9")]
        public void Fits_MissingOrInvalidVersion_IsTrueWithoutMismatch(string text)
        {
            Assert.That(NowposeVersion.Fits(text), Is.True);
            Assert.That(NowposeVersion.MismatchOf(text, "the gateway", "this headset"), Is.Null);
        }
    }
}
