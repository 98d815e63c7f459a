namespace Nowpose.Prefabs.Mrtk3;

/// <summary>Paths of the substitutes for prefabs of MRTK3. Their .meta files contain the GUIDs of the original prefabs.</summary>
static class ForeignPaths
{
    const string Mrtk = "Headless/StandIn/ForeignAssets/MixedReality.Toolkit/";

    public const string Button = Mrtk + "Action Button.prefab";
    public const string Toggle = Mrtk + "Action Button Checkbox.prefab";
    public const string Slider = Mrtk + "CanvasSlider.prefab";
    public const string HandMenu = Mrtk + "HandMenuBase.prefab";
    public const string Rig = Mrtk + "MRTK XR Rig.prefab";
    public const string Simulator = Mrtk + "MRTKInputSimulator.prefab";
}
