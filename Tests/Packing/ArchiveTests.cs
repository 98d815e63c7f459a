using System.Formats.Tar;
using System.IO.Compression;
using Nowpose.Packing;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Packing;

public sealed class ArchiveTests
{
    static readonly DateTimeOffset Time = new(2026, 3, 4, 5, 6, 8, TimeSpan.Zero);

    string _folder, _out;

    [SetUp]
    public void SetUp()
    {
        var root = Directory.CreateTempSubdirectory("nowpose-archive-").FullName;
        (_folder, _out) = (Path.Combine(root, "product-1.0"), Path.Combine(root, "out"));
        Directory.CreateDirectory(Path.Combine(_folder, "below"));
        Directory.CreateDirectory(_out);
        File.WriteAllText(Path.Combine(_folder, "below", "text.txt"), "hello");
        File.WriteAllText(Path.Combine(_folder, "program"), "runs");
        if (!OperatingSystem.IsWindows()) File.SetUnixFileMode(Path.Combine(_folder, "program"), UnixFileMode.UserRead | UnixFileMode.UserExecute);
    }

    [TearDown]
    public void TearDown() => Directory.Delete(Path.GetDirectoryName(_folder), true);

    byte[] Packed(string name)
    {
        var path = Path.Combine(_out, name);
        Archive.Write(path, ArchiveEntry.OfFolder(_folder, "product-1.0"), Time);
        return File.ReadAllBytes(path);
    }

    static List<TarEntry> Entries(byte[] packed)
    {
        using var reader = new TarReader(new GZipStream(new MemoryStream(packed), CompressionMode.Decompress));
        var entries = new List<TarEntry>();
        while (reader.GetNextEntry(copyData: true) is { } entry) entries.Add(entry);
        return entries;
    }

    [TestCase("a.tar.gz")]
    [TestCase("a.zip")]
    [TestCase("a.tar")]
    public void Write_SameFilesWithOtherModificationTimes_WritesTheSameBytes(string name)
    {
        var first = Packed(name);
        File.SetLastWriteTimeUtc(Path.Combine(_folder, "program"), DateTime.UnixEpoch);

        Assert.That(Packed(name), Is.EqualTo(first));
    }

    [Test]
    public void WriteTarGz_Folder_HasOneTopFolderAndSortedNames()
    {
        var entries = Entries(Packed("a.tar.gz"));

        Assert.That(entries.Select(entry => entry.Name), Is.EqualTo(
            new[] { "product-1.0/", "product-1.0/below/", "product-1.0/below/text.txt", "product-1.0/program" }));
        Assert.That(entries.Select(entry => (entry.Uid, entry.Gid, entry.ModificationTime)), Is.All.EqualTo((0, 0, Time)));
    }

    [Test]
    public void WriteTarGz_Program_KeepsOnlyTheExecutableBit()
    {
        if (OperatingSystem.IsWindows()) Assert.Ignore("Windows has no such bits");

        var modes = Entries(Packed("a.tar.gz")).ToDictionary(entry => entry.Name, entry => Convert.ToString((int)entry.Mode, 8));

        Assert.That(modes["product-1.0/program"], Is.EqualTo("755"));
        Assert.That(modes["product-1.0/below/text.txt"], Is.EqualTo("644"));
    }

    [Test]
    public void WriteTarGz_LinkToAFolder_WritesOnlyTheLink()
    {
        if (OperatingSystem.IsWindows()) Assert.Ignore("links need privileges on Windows");
        Directory.CreateSymbolicLink(Path.Combine(_folder, "link"), "below");

        var link = Entries(Packed("a.tar.gz")).Single(entry => entry.Name.StartsWith("product-1.0/link", StringComparison.Ordinal));

        Assert.That((link.EntryType, link.LinkName), Is.EqualTo((TarEntryType.SymbolicLink, "below")));
    }

    [Test]
    public void WriteZip_Folder_ContainsAllFiles()
    {
        using var zip = new ZipArchive(new MemoryStream(Packed("a.zip")));

        using var text = new StreamReader(zip.GetEntry("product-1.0/below/text.txt").Open());
        Assert.That(text.ReadToEnd(), Is.EqualTo("hello"));
        Assert.That(zip.Entries, Has.Count.EqualTo(2));
    }
}
