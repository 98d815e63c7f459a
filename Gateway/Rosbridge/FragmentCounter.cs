namespace Nowpose.Gateway.Rosbridge;

/// <summary>Counts the frames of each WebSocket message from the received bytes (RFC 6455, 5.2).</summary>
/// <remarks>
/// .NET's WebSocket returns bytes as they arrive and does not report the end of a frame, so a long frame over a slow network looks like many
/// fragments. Control frames, which may occur between fragments, are not counted. The payloads of pongs are passed to <see cref="Pong"/>.
/// </remarks>
sealed class FragmentCounter
{
    const int PongOpcode = 10;
    const int MaxControlPayload = 125;
    const int FinalBit = 0x80;
    const int MaskBit = 0x80;
    const int OpcodeBits = 0x0F;
    const int FirstControlOpcode = 8;
    const int MaskBytes = 4;

    readonly Lock _lock = new();
    readonly Queue<int> _finished = [];
    readonly byte[] _header = new byte[14];
    int _headerLength;
    int _headerNeeded = 2;
    long _payloadLeft;
    int _fragments;
    readonly byte[] _pong = new byte[MaxControlPayload];
    int _pongLength;
    bool _isPong;

    /// <summary>Receives the payload of each pong, on the receiving thread.</summary>
    public Action<ReadOnlyMemory<byte>> Pong { get; set; }

    /// <summary>Processes the next received bytes.</summary>
    public void Feed(ReadOnlySpan<byte> bytes)
    {
        while (bytes.Length > 0)
        {
            if (_payloadLeft > 0)
            {
                var skipped = (int)Math.Min(_payloadLeft, bytes.Length);
                if (_isPong) Keep(bytes[..skipped]);
                _payloadLeft -= skipped;
                if (_isPong && _payloadLeft == 0) Pong?.Invoke(_pong.AsMemory(0, _pongLength));
                bytes = bytes[skipped..];
                continue;
            }

            _header[_headerLength++] = bytes[0];
            bytes = bytes[1..];
            if (_headerLength == 2)
                _headerNeeded = 2 + LengthBytes(_header[1] & ~MaskBit) + ((_header[1] & MaskBit) != 0 ? MaskBytes : 0);
            if (_headerLength == _headerNeeded)
                EndOfHeader();
        }
    }

    /// <summary>Removes and returns the fragment count of the oldest message. Call it once for each completed message.</summary>
    public int Take()
    {
        lock (_lock)
            return _finished.TryDequeue(out var fragments) ? fragments : 0;
    }

    void EndOfHeader()
    {
        _payloadLeft = PayloadLength();
        _headerLength = 0;
        _headerNeeded = 2;
        _isPong = (_header[0] & OpcodeBits) == PongOpcode && _payloadLeft is > 0 and <= MaxControlPayload && (_header[1] & MaskBit) != 0;
        _pongLength = 0;
        if ((_header[0] & OpcodeBits) >= FirstControlOpcode)
            return;
        _fragments++;
        if ((_header[0] & FinalBit) == 0)
            return;
        lock (_lock)
            _finished.Enqueue(_fragments);
        _fragments = 0;
    }

    void Keep(ReadOnlySpan<byte> bytes)
    {
        // Unmasks the payload: the header of a client's pong is two bytes followed by the mask of four bytes.
        foreach (var one in bytes)
        {
            _pong[_pongLength] = (byte)(one ^ _header[2 + (_pongLength % MaskBytes)]);
            _pongLength++;
        }
    }

    long PayloadLength()
    {
        var first = _header[1] & ~MaskBit;
        var bytes = LengthBytes(first);
        if (bytes == 0)
            return first;
        var length = 0UL;
        foreach (var digit in _header.AsSpan(2, bytes))
            length = length << 8 | digit;
        // Accepts a length of more than 63 bits; the WebSocket closes the connection because of this protocol error.
        return (long)Math.Min(length, long.MaxValue);
    }

    static int LengthBytes(int first) => first switch { 126 => 2, 127 => 8, _ => 0 };
}
