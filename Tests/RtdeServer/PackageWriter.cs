using System.Buffers.Binary;
using System.Text;

namespace Nowpose.RtdeServer;

/// <summary>Writes one package: uint16 size of the whole package, uint8 type, payload. All numbers are big-endian.</summary>
sealed class PackageWriter
{
    const int HeaderSize = 3;

    byte[] _bytes = new byte[256];
    int _length = HeaderSize;

    public PackageWriter(PackageType type) => _bytes[2] = (byte)type;

    /// <summary>Returns the complete package.</summary>
    public ReadOnlyMemory<byte> Finish()
    {
        BinaryPrimitives.WriteUInt16BigEndian(_bytes, checked((ushort)_length));
        return _bytes.AsMemory(0, _length);
    }

    public PackageWriter Add(bool value) => Add((byte)(value ? 1 : 0));

    public PackageWriter Add(byte value)
    {
        Room(1)[0] = value;
        return this;
    }

    public PackageWriter Add(int value)
    {
        BinaryPrimitives.WriteInt32BigEndian(Room(4), value);
        return this;
    }

    public PackageWriter Add(uint value)
    {
        BinaryPrimitives.WriteUInt32BigEndian(Room(4), value);
        return this;
    }

    public PackageWriter Add(ulong value)
    {
        BinaryPrimitives.WriteUInt64BigEndian(Room(8), value);
        return this;
    }

    public PackageWriter Add(double value)
    {
        BinaryPrimitives.WriteDoubleBigEndian(Room(8), value);
        return this;
    }

    public PackageWriter Add(ReadOnlySpan<double> values)
    {
        foreach (var value in values) Add(value);
        return this;
    }

    /// <summary>Writes the characters without their count.</summary>
    public PackageWriter Add(string text)
    {
        Encoding.ASCII.GetBytes(text, Room(text.Length));
        return this;
    }

    Span<byte> Room(int size)
    {
        if (_length + size > _bytes.Length) Array.Resize(ref _bytes, Math.Max(2 * _bytes.Length, _length + size));
        _length += size;
        return _bytes.AsSpan(_length - size, size);
    }
}
