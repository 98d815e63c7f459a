using Nowpose.Gateway.Hub;

namespace Nowpose.Gateway.Status.Cell;

/// <summary>The newest message that was dropped because of its content.</summary>
/// <param name="Fault">The frame or signal and its fault as one clause.</param>
/// <param name="Reason">The fault with the source of the message.</param>
/// <param name="At">Time of the drop, a timestamp of the time provider.</param>
/// <param name="Since">Time of the first of the dropped messages.</param>
sealed record DroppedMessage(string Fault, string Reason, long At, DateTimeOffset Since);

/// <summary>A frame or signal of the <see cref="CellBoard"/>.</summary>
abstract class CellEntry
{
    public HubSource Source { get; set; }

    /// <summary>Whether at least one message was valid.</summary>
    public bool HasAny { get; set; }

    /// <summary>Whether the source of the newest valid message has ended normally.</summary>
    public bool HasLeft { get; set; }

    /// <summary>Whether the source has ended, so that another frame or signal may replace this one.</summary>
    public bool IsEnded { get; set; }

    /// <summary>Null if the newest message was valid.</summary>
    public DroppedMessage Refusal { get; set; }
}

/// <summary>A frame with its newest pose.</summary>
sealed class FrameEntry : CellEntry
{
    string _state;
    DateTimeOffset _since;

    public bool IsStationary { get; set; }

    public string Parent { get; set; }
    public ControlTime Stamp { get; set; }

    /// <summary>Whether the newest pose was too old when it arrived.</summary>
    public bool IsOld { get; set; }

    /// <summary>Arrival of the newest pose.</summary>
    public long ArrivedAt { get; set; }

    /// <summary>Arrival of the pose with the newest stamp.</summary>
    public long SeenAt { get; set; }

    /// <summary>Time at which <see cref="Enter"/> was first called with the present state, a timestamp of the time provider.</summary>
    public long EnteredAt { get; private set; }

    /// <summary>Returns the start of the present state.</summary>
    /// <param name="since">Start of the state if it is new.</param>
    public DateTimeOffset Enter(string state, DateTimeOffset since, long now)
    {
        if (_state != state) (_state, _since, EnteredAt) = (state, since, now);
        return _since;
    }
}

/// <summary>A signal with its newest value.</summary>
sealed class SignalEntry : CellEntry
{
    public long EndedAt { get; set; }
    public DateTimeOffset EndedUtc { get; set; }

    /// <summary>Null before the first valid message.</summary>
    public double? Value { get; set; }

    /// <summary>The newest valid message as a refusal, because its stamp is in the future; null if the stamp is not.</summary>
    public DroppedMessage Ahead { get; private set; }

    /// <summary>Stamp of the newest value.</summary>
    public ControlTime Newest { get; set; }

    /// <summary>Stamp of the message with which the value changed.</summary>
    public ControlTime Since { get; set; }

    /// <summary>Sets <see cref="Ahead"/>. Its reason states how far the stamp was ahead at first, so that it does not change with the time.</summary>
    /// <param name="by">How far the stamp is in the future; null if it is not.</param>
    public void SetAhead(TimeSpan? by, TimeProvider time)
    {
        var reason = by == null ? null : CellReasons.StampAhead(by.Value.TotalSeconds);
        Ahead = reason == null ? null : Ahead ?? new DroppedMessage(reason, reason, time.GetTimestamp(), time.GetUtcNow());
    }
}
