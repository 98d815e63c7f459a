using System.Security.Cryptography;
using Nowpose.Gateway.Security;
using Nowpose.Pairing;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Security;

public class TokenStrengthTests
{
    [TestCase("observer-token", 14 * 5.858)]
    [TestCase("12345678", 8 * 3.3219)]
    [TestCase("0123456789abcdef0123456789abcdef", 128)]
    [TestCase("0123456789ABCDEF0123456789ABCDE", 124)]
    [TestCase("aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa", 0)]
    [TestCase("Tr0ub4dor&3", 11 * 6.5546)]
    public void BitsOf_Token_IsItsLengthTimesTheBitsOfItsAlphabet(string token, double bits) =>
        Assert.That(TokenStrength.BitsOf(token), Is.EqualTo(bits).Within(0.01));

    [Test]
    public void BitsOf_RandomHexadecimal128BitTokens_AreSufficient()
    {
        var random = new Random(7);
        var bytes = new byte[16];
        for (var i = 0; i < 10_000; i++)
        {
            random.NextBytes(bytes);
            var token = Convert.ToHexStringLower(bytes);
            Assert.That(TokenStrength.BitsOf(token), Is.GreaterThanOrEqualTo(TokenStrength.MinBits), $"seed 7, {token}");
        }
    }

    [Test]
    public void Tokens_CreatedByTheGateway_AreStrong()
    {
        using var folder = new TemporaryFolder();
        var list = new Nowpose.Gateway.Pairing.HeadsetList(Path.Combine(folder.Path, "headsets.txt"));

        Assert.That(TokenStrength.BitsOf(list.Add("a", out _)), Is.GreaterThan(TokenStrength.MinBits));
        Assert.That(TokenStrength.BitsOf(Gateways.Options().AdapterToken), Is.GreaterThan(TokenStrength.MinBits));
        Assert.That(TokenCode.TokenBytes * 8, Is.GreaterThanOrEqualTo(TokenStrength.MinBits), "a pairing code is valid only for minutes");
    }

    [Test]
    public async Task TokensFile_WithAWeakToken_CausesAWarningWithItsLineNumber()
    {
        using var folder = new TemporaryFolder();
        var path = Path.Combine(folder.Path, "tokens.txt");
        var strong = Convert.ToHexString(RandomNumberGenerator.GetBytes(16));
        await File.WriteAllTextAsync(path, $"# a comment\nsource {strong}\n\nobserver hunter2\n# observer old\n");
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { Tokens = TokenList.Read(path) });

        var warning = gateway.Warnings.Single(line => line.Contains("bits"));

        Assert.That(warning, Does.Contain($"{path}, line 4").And.Contain("36 bits").And.Contain("128 bits").And.Contain("openssl"));
        Assert.That(warning, Does.Not.Contain("hunter2"));
    }

    [Test]
    public void Follow_FileGetsAWeakToken_LogsTheWarningOnceForEachChange()
    {
        using var folder = new TemporaryFolder();
        var path = Path.Combine(folder.Path, "tokens.txt");
        var strong = Convert.ToHexString(RandomNumberGenerator.GetBytes(16));
        File.WriteAllText(path, $"source {strong}\n");
        var log = new List<string>();
        var tokens = TokenList.Read(path, log.Add);

        // A change is read when it is older than some milliseconds, so that a program can finish writing the file.
        File.WriteAllText(path, $"source {strong}\nobserver hunter2\n");
        File.SetLastWriteTimeUtc(path, DateTime.UtcNow.AddSeconds(-10));
        tokens.Follow();
        tokens.Follow();

        Assert.That(log.Single(), Does.Contain($"{path}, line 2").And.Contain("36 bits").And.Not.Contain("hunter2"));
        Assert.That(tokens.Weak.Select(one => one.Where), Is.EqualTo(new[] { $"{path}, line 2" }));

        File.WriteAllText(path, $"source {strong}\n");
        File.SetLastWriteTimeUtc(path, DateTime.UtcNow.AddSeconds(-5));
        tokens.Follow();

        Assert.That(tokens.Weak, Is.Empty);
        Assert.That(log, Has.Count.EqualTo(1));
    }
}
