using Nowpose.Motion;

namespace Nowpose.Cli.Studies;

/// <summary>Builds a motion from moves and dwells.</summary>
sealed class MoveSequence
{
    readonly List<Piece> _pieces = [];

    /// <summary>Position at the current end of the sequence.</summary>
    public double End { get; private set; }

    /// <summary>Current duration of the sequence, s.</summary>
    public double Seconds { get; private set; }

    public void Dwell(double seconds) => Seconds += seconds;

    /// <summary>Adds a 7-phase move to a position.</summary>
    public void MoveTo(double position, double velocity, double acceleration, double jerk)
    {
        var profile = new SevenPhaseProfile(position - End, velocity, acceleration, jerk);
        Add(position, profile.Duration, profile.PositionAt);
    }

    /// <param name="covered">Returns the distance covered at a given time since the start of the piece, s.</param>
    public void Add(double end, double duration, Func<double, double> covered)
    {
        _pieces.Add(new Piece(Seconds, duration, End, end, covered));
        End = end;
        Seconds += duration;
    }

    public AxisMotion Motion(string name) => new(name, Seconds, At);

    public double At(double t)
    {
        var started = SortedSearch.CountUpTo(_pieces, t, piece => piece.Start);
        if (started == 0) return _pieces.Count == 0 ? End : _pieces[0].From;
        var piece = _pieces[started - 1];
        return t - piece.Start >= piece.Duration ? piece.To : piece.From + piece.Covered(t - piece.Start);
    }

    sealed record Piece(double Start, double Duration, double From, double To, Func<double, double> Covered);
}
