using Nowpose.Gateway.Messages;
using NUnit.Framework;
using Nowpose.Gateway.Pairing;
using Nowpose.Gateway.Security;

namespace Nowpose.Headless.Tests.Gateway;

public sealed class HeadsetFileTests
{
    static readonly PairedHeadset First = new("first", new DateTime(2026, 11, 20, 12, 0, 0, DateTimeKind.Utc), TokenList.HashOf("a"));
    static readonly PairedHeadset Second = First with { Name = "second  one", Hash = TokenList.HashOf("b") };

    string _folder, _path;

    [SetUp]
    public void Create()
    {
        _folder = Directory.CreateTempSubdirectory("nowpose-headsets-").FullName;
        _path = Path.Combine(_folder, "headsets.txt");
    }

    [TearDown]
    public void Remove() => Directory.Delete(_folder, true);

    [Test]
    public void Load_SeveralHeadsetsAdded_ReturnsThemInOrder()
    {
        HeadsetFile.Open(_path);
        HeadsetFile.Add(_path, First);
        HeadsetFile.Add(_path, Second);

        Assert.That(HeadsetFile.Load(_path).Select(headset => headset.ToString()), Is.EqualTo(new[] { First.ToString(), Second.ToString() }));
        Assert.That(HeadsetFile.Load(_path)[1].Name, Is.EqualTo("second  one"));
    }

    [Test]
    public void Add_LastLineWithoutLineEnd_StartsANewLine()
    {
        File.WriteAllText(_path, First.ToString());

        HeadsetFile.Add(_path, Second);

        Assert.That(HeadsetFile.Load(_path), Has.Count.EqualTo(2));
    }

    [Test]
    public void Remove_OneHeadset_KeepsCommentsOtherHeadsetsAndTheFileMode()
    {
        HeadsetFile.Open(_path);
        HeadsetFile.Add(_path, First);
        File.AppendAllText(_path, "# of the night shift\n");
        HeadsetFile.Add(_path, Second);

        HeadsetFile.Remove(_path, [First]);

        var left = File.ReadAllLines(_path);
        Assert.That(left, Has.Length.EqualTo(3));
        Assert.That(left[1], Is.EqualTo("# of the night shift"));
        Assert.That(left[2], Is.EqualTo(Second.ToString()));
        if (!OperatingSystem.IsWindows())
            Assert.That(File.GetUnixFileMode(_path), Is.EqualTo(UnixFileMode.UserRead | UnixFileMode.UserWrite));
    }

    [Test]
    public async Task AddAndRemove_Concurrently_KeepAllEntries()
    {
        HeadsetFile.Open(_path);
        var gone = Enumerable.Range(0, 30).Select(i => First with { Name = "gone " + i }).ToList();
        foreach (var headset in gone) HeadsetFile.Add(_path, headset);

        await Task.WhenAll(
            Task.Run(() => Enumerable.Range(0, 30).ToList().ForEach(i => HeadsetFile.Add(_path, Second with { Name = "new " + i }))),
            Task.Run(() => gone.ForEach(headset => HeadsetFile.Remove(_path, [headset])))).Bounded();

        Assert.That(
            HeadsetFile.Load(_path).Select(headset => headset.Name), Is.EqualTo(Enumerable.Range(0, 30).Select(i => "new " + i)));
    }

    [Test]
    public void List_RevocationAndADamagedLine_RefusesTheRevokedToken()
    {
        var log = new List<string>();
        HeadsetFile.Open(_path);
        HeadsetFile.Add(_path, First);
        HeadsetFile.Add(_path, Second);
        var list = new HeadsetList(_path, log: log.Add);
        Assert.That((list.Contains(First.Hash), list.Contains(Second.Hash)), Is.EqualTo((true, true)));

        File.WriteAllText(_path, Second + "\nobserver oops\n");

        Assert.That((list.Contains(First.Hash), list.Contains(Second.Hash)), Is.EqualTo((false, true)));
        Assert.That(log, Has.Exactly(1).Items.And.All.Contains(HeadsetListMessages.NotAnEntry(_path, 2)));
    }

    [TestCase("observer TOKEN")]
    [TestCase("source sha256/AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA= 2026-11-20T12:00:00Z a")]
    [TestCase("observer sha256/AAAA 2026-11-20T12:00:00Z a")]
    [TestCase("observer sha256/AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA= yesterday a")]
    [TestCase("observer sha256/AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA= 2026-11-20T12:00:00Z")]
    public void Load_InvalidLine_ThrowsWithFileAndLineNumberOnly(string line)
    {
        File.WriteAllText(_path, "# head\n" + line + "\n");

        var error = Assert.Throws<InputException>(() => HeadsetFile.Load(_path));

        Assert.That(error.Message, Is.EqualTo(HeadsetListMessages.NotAnEntry(_path, 2)));
    }

    [TestCase(null, "headset")]
    [TestCase(" \t\n", "headset")]
    [TestCase(" a\u0000b\n ", "ab")]
    [TestCase("a\u202Eb\u2028c\u200Bd", "abcd")]
    public void NameOf_TextWithControlCharacters_IsOneLineWithoutThem(string name, string expected) =>
        Assert.That(PairedHeadset.NameOf(name), Is.EqualTo(expected));

    [Test]
    public void NameOf_LongText_IsShortened() => Assert.That(PairedHeadset.NameOf(new string('a', 500)), Has.Length.EqualTo(64));
}
