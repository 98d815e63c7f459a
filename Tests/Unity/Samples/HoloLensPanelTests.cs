using MixedReality.Toolkit.UX;
using Nowpose.Messages;
using Nowpose.Pairing;
using Nowpose.Protocol;
using Nowpose.Unity;
using Nowpose.Unity.Tests.Pairing;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Samples;

/// <summary>Tests the panel of the sample: its place, its questions, and its guidance through the pairing.</summary>
public sealed class HoloLensPanelTests
{
    PlayedHoloLens _sample;

    [SetUp]
    public void Begin() => _sample = new PlayedHoloLens();

    [TearDown]
    public void End() => _sample.Dispose();

    [Test]
    public void Marker_GraspedAndMoved_BaseFollowsAndStays()
    {
        var anchor = _sample.Child<BaseAnchor>("Base Anchor").transform;
        var marker = _sample.Child<HandPlacedMarker>("Hand-Placed Marker").transform;

        _sample.Grasp("Hand-Placed Marker", m => m.SetPositionAndRotation(new Vector3(0.4f, 0.1f, 2), Quaternion.Euler(0, 60, 0)));

        Assert.That(Vector3.Distance(anchor.position, marker.position), Is.LessThan(1e-3));
        Assert.That(Vector3.Distance(anchor.position, new Vector3(0.4f, 0.1f, 2)), Is.LessThan(1e-3));
        Assert.That(Quaternion.Angle(anchor.rotation, marker.rotation), Is.LessThan(0.1));
    }

    [Test]
    public void Marker_ReleasedTilted_BaseAndMarkerAreUpright()
    {
        var anchor = _sample.Child<BaseAnchor>("Base Anchor").transform;
        var marker = _sample.Child<HandPlacedMarker>("Hand-Placed Marker").transform;
        var place = new Vector3(0.4f, 0.1f, 2);

        _sample.Grasp("Hand-Placed Marker", m => m.SetPositionAndRotation(place, Quaternion.Euler(0, 60, 0) * Quaternion.Euler(3, 0, -2)));

        Assert.That(Quaternion.Angle(anchor.rotation, Quaternion.Euler(0, 60, 0)), Is.LessThan(0.2));
        Assert.That(Vector3.Distance(anchor.position, place), Is.LessThan(1e-3));
        Assert.That(Quaternion.Angle(anchor.rotation, marker.rotation), Is.LessThan(0.1), "the marker stays at the base");
    }

    [Test]
    public void Marker_ReleasedTiltedWithoutKeepUpright_BaseIsTilted()
    {
        var anchor = _sample.Child<BaseAnchor>("Base Anchor").transform;
        var rotation = Quaternion.Euler(90, 60, 0);
        _sample.Child<HandPlacedMarker>("Hand-Placed Marker").With("_keepUpright", false);

        _sample.Grasp("Hand-Placed Marker", m => m.SetPositionAndRotation(new Vector3(0.4f, 0.1f, 2), rotation));

        Assert.That(Quaternion.Angle(anchor.rotation, rotation), Is.LessThan(0.1));
    }

    [Test]
    public void Panel_GraspedByItsBar_StaysUntilUnpinned()
    {
        var panel = _sample.Child<BodyFollow>("Status Panel (MRTK3)");

        _sample.Grasp("Bar", p => p.position = new Vector3(1, 1, 1));
        _sample.Run(2);
        var stays = panel.transform.position;
        _sample.Press("Pin");

        Assert.That(stays, Is.EqualTo(new Vector3(1, 1, 1)));
        Assert.That(panel.enabled, Is.True);
    }

    [Test]
    public void Panel_Closed_IsHiddenAndTheMenuShowsIt()
    {
        _sample.ShowTheHand();
        _sample.Press("Close");

        Assert.That(_sample.Actions.IsPanelShown, Is.False);
        Assert.That(_sample.Child<PressableButton>("Panel").IsToggled.Active, Is.False);
    }

    [TestCase("Accept", "desk")]
    [TestCase("Refuse", null)]
    public void Consent_CodeInView_IsRequestedAndGivenByAButton(string button, string expected)
    {
        var codes = ShownCodes.Below(_sample.Session);
        codes.Texts.Add(new CellCode("desk", "127.0.0.1", null, MarkerOffset.Parse("0.5,0,0", ""), 0.1, 1, 1).Text);
        Show(codes, 2);
        Assert.That(_sample.Child<TextMesh>("Question").text, Is.Not.Empty);

        _sample.Press(button);

        Assert.That(_sample.Session.GetComponent<CellPairing>().Cell, Is.EqualTo(expected));
        Assert.That(_sample.Child<Transform>("Content").gameObject.activeSelf, Is.False);
    }

    /// <summary>The wearer leans towards a code of 100 mm on a surface, which is read from at most 0.47 m, and answers while looking at it.</summary>
    [Test]
    public void Consent_WearerInFrontOfACode_ButtonsAreNearerThanTheCodeAndInView()
    {
        const float codeMetres = 0.47f, halfViewDegrees = 21.5f;
        var camera = _sample.Child<Camera>("Main Camera").transform;
        _sample.Run(2);
        camera.position += 0.15f * camera.forward;
        var codes = ShownCodes.Below(_sample.Session);
        codes.Texts.Add(new CellCode("desk", "127.0.0.1", null, MarkerOffset.Parse("0.5,0,0", ""), 0.1, 1, 1).Text);
        Show(codes, 4);

        var prompt = _sample.Child<BodyFollow>("Content").transform;
        var ground = prompt.GetComponentsInChildren<Transform>(true).Single(t => t.name == "Ground");

        Assert.That(Vector3.Distance(camera.position, prompt.position), Is.InRange(0.4f, codeMetres - 0.01f));
        Assert.That(Math.Atan2(ground.lossyScale.x / 2, Vector3.Distance(camera.position, prompt.position)) * 180 / Math.PI, Is.LessThan(halfViewDegrees));
    }

    [TestCase("Accept", null)]
    [TestCase("Refuse", "desk")]
    public void ForgetCell_Pressed_AsksForConfirmation(string button, string left)
    {
        var codes = ShownCodes.Below(_sample.Session);
        codes.Texts.Add(new CellCode("desk", "127.0.0.1", null, MarkerOffset.Parse("0.5,0,0", ""), 0.1, 1, 1).Text);
        Show(codes, 2);
        _sample.Press("Accept");
        codes.Texts.Clear();
        _sample.Run(4);
        _sample.ShowTheHand();
        _sample.Run();

        _sample.Press("Forget Cell");
        _sample.Run();
        Assert.That(_sample.Child<TextMesh>("Question").text, Does.Contain("desk"));
        Assert.That(_sample.Session.GetComponent<CellPairing>().Cell, Is.EqualTo("desk"), "the wearer is asked first");
        _sample.Run(2);
        _sample.Press(button);
        _sample.Run();

        Assert.That(_sample.Session.GetComponent<CellPairing>().Cell, Is.EqualTo(left));
    }

    string Message => _sample.Child<TextMesh>("Message 0").text.Replace('\n', ' ');

    void Show(ShownCodes codes, double seconds)
    {
        for (var left = seconds; left > 0; left -= 0.02)
        {
            codes.Seen = _sample.Cell.Clock.Now;
            _sample.Run(0.02);
        }
    }

    [Test]
    public async Task Panel_HeadsetNotPaired_GuidesThroughThePairingAndShowsFailures()
    {
        var pin = CertificatePin.Parse(Convert.ToBase64String(new byte[32]));
        var codes = ShownCodes.Below(_sample.Session);
        Show(codes, 1);
        Assert.That(Message, Is.EqualTo(PairingMessages.LookAtMarker));

        codes.Texts.Add(new CellCode("desk", "127.0.0.1", pin, MarkerOffset.Parse("0.5,0,0", ""), 0.1, 1, 1).Text);
        Show(codes, 2);
        _sample.Press("Accept");
        Show(codes, 1);
        Assert.That(Message, Is.EqualTo(PairingMessages.LookAtCode("desk")));

        // The pairing with this code fails, because its port is closed.
        codes.Texts.Add(new TokenCode(pin, "AAAAAAAAAAAAAAAAAAAAAA").Text);
        await Soon.BecomesAsync(() =>
        {
            Show(codes, 0.3);
            return Message.StartsWith("! " + PairingAnswerMessages.Failed("127.0.0.1", ""), StringComparison.Ordinal);
        }, "the panel says why pairing fails");
    }
}
