using System.Formats.Tar;
using System.IO.Compression;

namespace Nowpose.Packing;

/// <summary>Writes archives whose bytes depend only on the entries and the given time.</summary>
public static class Archive
{
    /// <summary>Writes a .zip, .tar or .tar.gz file. The extension of the path selects the format.</summary>
    public static void Write(string path, IEnumerable<ArchiveEntry> entries, DateTimeOffset time)
    {
        using var file = File.Create(path);
        if (path.EndsWith(".zip", StringComparison.Ordinal)) WriteZip(file, entries, time);
        else if (path.EndsWith(".gz", StringComparison.Ordinal)) WriteTarGz(file, entries, time);
        else WriteTar(file, entries, time);
    }

    public static void WriteTarGz(Stream stream, IEnumerable<ArchiveEntry> entries, DateTimeOffset time)
    {
        using var compressed = new GZipStream(stream, CompressionLevel.Optimal, leaveOpen: true);
        WriteTar(compressed, entries, time);
    }

    public static void WriteTar(Stream stream, IEnumerable<ArchiveEntry> entries, DateTimeOffset time)
    {
        // The GNU format has no limit for the length of names, and its only time stamp is the modification time.
        using var tar = new TarWriter(stream, TarEntryFormat.Gnu, leaveOpen: true);
        foreach (var entry in entries)
        {
            using var content = entry.Open?.Invoke();
            var written = new GnuTarEntry(TypeOf(entry), entry.IsFolder ? entry.Name + "/" : entry.Name)
            {
                Mode = entry.Mode, ModificationTime = time, Uid = entry.Owner, Gid = entry.Owner,
            };
            if (entry.LinkTarget != null) written.LinkName = entry.LinkTarget;
            if (content != null) written.DataStream = content;
            tar.WriteEntry(written);
        }
    }

    static TarEntryType TypeOf(ArchiveEntry entry) =>
        entry.IsFolder ? TarEntryType.Directory : entry.LinkTarget == null ? TarEntryType.RegularFile : TarEntryType.SymbolicLink;

    static void WriteZip(Stream stream, IEnumerable<ArchiveEntry> entries, DateTimeOffset time)
    {
        using var zip = new ZipArchive(stream, ZipArchiveMode.Create);
        foreach (var entry in entries.Where(entry => !entry.IsFolder))
        {
            if (entry.LinkTarget != null) throw new InvalidDataException($"{entry.Name}: a zip file for Windows cannot have symbolic links");
            var zipped = zip.CreateEntry(entry.Name, CompressionLevel.Optimal);
            zipped.LastWriteTime = time;
            zipped.ExternalAttributes = (int)entry.Mode << 16;
            using var target = zipped.Open();
            using var content = entry.Open();
            content.CopyTo(target);
        }
    }
}
