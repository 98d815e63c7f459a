namespace Nowpose.Gateway.Rosbridge;

/// <summary>Counts the frames of which each message of a WebSocket consists, from the bytes as they come (RFC 6455, 5.2).</summary>
/// <remarks>
/// The WebSocket classes hand out bytes as they arrive and do not tell where a frame ends: a long frame over a slow network
/// looks there like many fragments. Control frames, which may stand between fragments, do not count; pongs are handed on.
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

    /// <summary>Takes the payload of each pong, on the thread that receives.</summary>
    public Action<ReadOnlyMemory<byte>> Pong { get; set; }

    /// <summary>Takes the bytes that follow those of the call before.</summary>
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

    /// <summary>The fragments of the oldest message not asked for yet: to be called once for each message that ended.</summary>
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
        // A client masks what it sends with the last four bytes of the frame's header, which is two bytes long without them.
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
        // A length beyond 63 bits is an error that the WebSocket itself closes on.
        return (long)Math.Min(length, long.MaxValue);
    }

    static int LengthBytes(int first) => first switch { 126 => 2, 127 => 8, _ => 0 };
}
