namespace Microsoft.MixedReality.OpenXR;

public enum ARMarkerType
{
    QRCode = 1,
}
