using Nowpose.ArFoundation;
using Nowpose.Mrtk3;
using Nowpose.OpenXR;
using Unity.XR.CoreUtils;
using UnityEngine.XR.ARFoundation;

namespace Nowpose.Prefabs.Mrtk3;

/// <summary>Creates the scene of a robot cell for a HoloLens 2 with MRTK3: pairing, hand menu, movable panel and movable marker.</summary>
static class HoloLensScene
{
    public static string Make(PackageAssets assets)
    {
        var rig = assets.Instantiate(ForeignPaths.Rig, null);
        var simulator = assets.Instantiate(ForeignPaths.Simulator, null);
        var ar = new GameObject("AR Session");
        ar.AddComponent<ARSession>();
        var cell = Cell(assets, rig.GetComponentInChildren<XROrigin>(includeInactive: true));
        var session = cell.GetComponent<MrilSession>();
        var panel = Panel(assets, session);
        var menu = Menu(assets, session, panel);
        var consent = assets.Instantiate(PackagePaths.HoloLensConsent, null);
        Fields.Set(consent.GetComponent<ConsentPrompt>(), "_pairing", cell.GetComponent<CellPairing>());
        return assets.Scene(rig, simulator, ar, Props.Light(hasShadows: false), cell, panel.gameObject, menu, consent);
    }

    static GameObject Cell(PackageAssets assets, XROrigin origin)
    {
        var cell = Scenes.Cell(assets, PackagePaths.Cell, PackagePaths.HoloLensSettings);
        var session = cell.GetComponent<MrilSession>();
        // Does not connect at startup. The hand menu connects, or the pairing does so after it has received the address.
        Fields.Set(session, "_connectOnEnable", false);
        cell.transform.Find("Base Anchor").localPosition = AnyHeadsetScene.BasePlace;
        cell.transform.Find("Status Panel").gameObject.SetActive(false);
        var codes = cell.AddComponent<QrMarkers>();
        Fields.Set(codes, "_session", session);
        Fields.Set(codes, "_origin", origin);
        Fields.Set(cell.AddComponent<ArSpatialAnchors>(), "_origin", origin);
        cell.AddComponent<OpenXrAnchorStore>();
        Fields.Set(cell.AddComponent<OpenXrDisplayTime>(), "_session", session);
        Fields.Set(cell.AddComponent<ReprojectionCheck>(), "_session", session);
        var pairing = cell.AddComponent<CellPairing>();
        Fields.Set(pairing, "_session", session);
        Fields.Set(pairing, "_anchor", cell.GetComponentInChildren<BaseAnchor>(includeInactive: true));
        var marker = assets.Instantiate(PackagePaths.HoloLensMarker, cell.transform);
        marker.transform.localPosition = AnyHeadsetScene.BasePlace;
        return cell;
    }

    static StatusPanel Panel(PackageAssets assets, MrilSession session)
    {
        var panel = assets.Instantiate(PackagePaths.HoloLensPanel, null).GetComponent<StatusPanel>();
        Fields.Set(panel, "_session", session);
        return panel;
    }

    static GameObject Menu(PackageAssets assets, MrilSession session, StatusPanel panel)
    {
        var menu = assets.Instantiate(PackagePaths.HoloLensMenu, null);
        CellObjects.Assign(assets, menu.GetComponent<CellActions>(), session, panel);
        return menu;
    }
}
