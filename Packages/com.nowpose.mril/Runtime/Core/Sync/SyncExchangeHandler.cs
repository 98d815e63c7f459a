namespace Nowpose.Sync
{
    /// <summary>Handles an exchange with its verdict.</summary>
    /// <param name="fault">Reason for dropping the exchange, or <see cref="SyncExchangeFault.None"/>.</param>
    delegate void SyncExchangeHandler(in SyncExchange exchange, SyncVerdict verdict, SyncExchangeFault fault);
}
