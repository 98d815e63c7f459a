namespace Nowpose.Protocol
{
    /// <summary>The operations of rosbridge v2 that headset and gateway exchange.</summary>
    public enum RosbridgeOp
    {
        /// <summary>One this protocol has no use for.</summary>
        Unknown,

        Subscribe,
        Unsubscribe,
        Advertise,
        Unadvertise,
        Publish,
        CallService,
        ServiceResponse,
        Status,
    }
}
