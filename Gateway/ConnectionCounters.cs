namespace Nowpose.Gateway;

/// <summary>Counts current and past connections and the reasons why they ended. Thread-safe.</summary>
public sealed class ConnectionCounters
{
    readonly long[] _closures = new long[Enum.GetValues<Closure>().Length];
    int _open;
    long _accepted;
    long _refused;

    public int Open => Volatile.Read(ref _open);
    public long Accepted => Interlocked.Read(ref _accepted);

    /// <summary>Number of new connections that were refused because of the limit.</summary>
    internal long Refused => Interlocked.Read(ref _refused);

    public long this[Closure closure] => Interlocked.Read(ref _closures[(int)closure]);

    /// <summary>
    /// Counts a connection as open if fewer than <paramref name="limit"/> are open. It counts as open until <see cref="Leave"/> is called.
    /// </summary>
    /// <param name="isFinal">Whether a connection beyond the limit counts as refused; false if the caller may try again.</param>
    /// <returns>False if the limit was reached.</returns>
    internal bool TryEnter(int limit, bool isFinal = true)
    {
        if (Interlocked.Increment(ref _open) <= limit)
        {
            Interlocked.Increment(ref _accepted);
            return true;
        }

        Interlocked.Decrement(ref _open);
        if (isFinal)
        {
            Interlocked.Increment(ref _refused);
            Count(Closure.ConnectionLimit);
        }

        return false;
    }

    internal void Leave(Closure why)
    {
        Count(why);
        Interlocked.Decrement(ref _open);
    }

    /// <summary>Counts a connection that could not be accepted, if the reason is the number of file descriptors.</summary>
    internal void CountFailure(Exception e)
    {
        if (DescriptorLimit.IsReached(e)) Count(Closure.DescriptorLimit);
    }

    internal void Count(Closure why) => Interlocked.Increment(ref _closures[(int)why]);
}
