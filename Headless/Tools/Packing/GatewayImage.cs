namespace Nowpose.Packing;

/// <summary>Creates the gateway's container image without a base image, from the C libraries and the packed program with its runtimes.</summary>
public static class GatewayImage
{
    /// <summary>
    /// Id of the user <c>app</c> in .NET's container images. The image that the Containerfile builds has the same id, so both images can use the same
    /// files.
    /// </summary>
    public const int User = 1654;

    /// <param name="libraries">Folder that contains the system's libraries at their paths in the image.</param>
    /// <param name="program">Folder that contains the packed gateway.</param>
    public static void Add(ImageLayout layout, string architecture, string containerfile, string libraries, string program)
    {
        var settings = ImageSettings.Read(containerfile, User);
        layout.Add(
            architecture, settings, ("C libraries and OpenSSL", ArchiveEntry.OfFolder(libraries, "")),
            ("Nowpose gateway", [.. System(settings), .. ArchiveEntry.OfFolder(program, "opt/nowpose-gateway")]));
    }

    static IEnumerable<ArchiveEntry> System(ImageSettings settings) =>
    [
        ArchiveEntry.Folder("etc"),
        ArchiveEntry.Folder("etc/nowpose"),
        ArchiveEntry.Text("etc/passwd", $"root:x:0:0:root:/root:/bin/false\napp:x:{User}:{User}::/{settings.State}:/bin/false\n"),
        ArchiveEntry.Text("etc/group", $"root:x:0:\napp:x:{User}:\n"),
        ArchiveEntry.Folder("opt"),
        ArchiveEntry.Folder("tmp") with { Mode = (UnixFileMode)0b1_111_111_111 },
        ArchiveEntry.Folder("var"),
        ArchiveEntry.Folder("var/lib"),
        ArchiveEntry.Folder(settings.State) with { Owner = settings.UserId },
    ];
}
