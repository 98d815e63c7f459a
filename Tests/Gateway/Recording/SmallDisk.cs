using System.Text;

namespace Nowpose.Headless.Tests.Gateway.Recording;

/// <summary>Simulates a disk with limited space. Like a real disk, it writes the part of the data that fits.</summary>
sealed class SmallDisk(int room) : MemoryStream
{
    public bool IsDisposed { get; private set; }
    public string Text => Encoding.UTF8.GetString(ToArray());

    public override void Write(ReadOnlySpan<byte> buffer)
    {
        var fitting = Math.Min(buffer.Length, room - (int)Position);
        base.Write(buffer[..fitting]);
        if (fitting < buffer.Length) throw new IOException("No space left on device");
    }

    protected override void Dispose(bool disposing)
    {
        IsDisposed = true;
        base.Dispose(disposing);
    }
}
