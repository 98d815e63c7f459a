namespace Nowpose.Sync
{
    /// <summary>Is told of an exchange that was judged.</summary>
    /// <param name="fault">Why it was dropped; none otherwise.</param>
    delegate void SyncExchangeHandler(in SyncExchange exchange, SyncVerdict verdict, SyncExchangeFault fault);
}
